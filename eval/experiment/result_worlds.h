// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/pipeline/candidate_decision.h"
#include "eval/datasets/open_dataset.h"

namespace hydrabench {

/// A world of a result folder that `run` wrote, with the predictions made of it.
struct ResultWorld {
  std::string dataset;  ///< its name in that result
  std::string seed;
  std::vector<std::filesystem::path> predictions;  ///< folders named after the methods, sorted
  std::string config;                              ///< YAML of the dataset, every key resolved

  /// Throws InputError, for folder datasets too.
  OpenedDataset open() const;
  std::string label() const { return dataset + "_" + seed; }
};

/// The worlds of a result, sorted by dataset and seed (as a number). The predictions are those that
/// are there; the datasets those of its config.yaml. Throws InputError where the folder is no
/// result of `run`.
std::vector<ResultWorld> resultWorlds(const std::filesystem::path& result);

/// The decision rules in the resolved config of a run (config.yaml of its prediction).
DecisionConfig readDecisionOf(const std::filesystem::path& prediction);

}  // namespace hydrabench

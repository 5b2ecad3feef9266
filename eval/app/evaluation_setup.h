// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "eval/datasets/open_dataset.h"
#include "eval/evaluation/evaluation_config.h"

namespace hydrabench {

/// A dataset and the way to score on it, as evaluate and selftest take them: overrides start with
/// "dataset." or "evaluation.".
struct EvaluationSetup {
  OpenedDataset dataset;
  EvaluationConfig evaluation;
  std::string resolved_config;  ///< YAML with both sections
};

/// One YAML document out of the two.
std::string combinedConfig(const std::string& dataset_yaml, const std::string& evaluation_yaml);

/// Throws InputError, also for an override with another prefix.
EvaluationSetup openEvaluation(const std::filesystem::path& dataset_config,
                               const std::vector<std::string>& overrides);

}  // namespace hydrabench

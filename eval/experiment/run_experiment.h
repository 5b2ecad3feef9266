// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "core/io/atomic_file.h"
#include "eval/experiment/experiment_config.h"
#include "eval/report/result_folder.h"

namespace hydrabench {

/// What is to be told while an experiment runs.
struct ExperimentEvents {
  /// A world is open and about to be mapped.
  std::function<void(const std::string& dataset, const std::string& seed, std::size_t frames)>
      on_world;
  std::function<void()> on_frame;
  std::function<void(const std::string&)> on_failure;
};

struct ExperimentOutcome {
  Result result;
  std::size_t predictions = 0;        ///< that were finished
  std::vector<std::string> failures;  ///< one line each; what did not fail is in the result
  std::map<std::string, double> frame_period_s;  ///< per dataset
};

/// Maps every world with every method and scores what has ground truth; with several seeds of a
/// dataset also all of them together. A world or method that fails is noted and the rest goes on.
/// Predictions are written to `folder`/predictions/DATASET/SEED/METHOD on the way. Throws
/// InputError where the first world cannot even be begun.
ExperimentOutcome runExperiment(const ExperimentConfig& experiment,
                                const std::filesystem::path& folder,
                                const ExperimentEvents& events);

}  // namespace hydrabench

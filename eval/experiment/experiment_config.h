// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "eval/datasets/open_dataset.h"
#include "eval/evaluation/evaluation_config.h"
#include "eval/experiment/method_table.h"

namespace hydrabench {

/// A YAML file that says what to run on what:
///
///     name: table1
///     datasets:
///       - config: ../datasets/office.yaml
///         seeds: [1, 2, 3]             # of generated worlds; without it the dataset as it is
///         set: ["masks.miss_probability=0.1"]
///     methods:
///       - config: ../methods/hydra.yaml
///       - config: ../methods/hydra.yaml
///         name: hydra_tight
///         set: ["clustering.tolerance_m=0.1"]
///     evaluation: {voxel_pitch_m: 0.05}
struct ExperimentConfig {
  /// One world to map: a dataset, for generated ones with a seed.
  struct World {
    std::filesystem::path config;
    std::vector<std::string> overrides;
  };
  std::string name;
  std::vector<World> worlds;  ///< in order; seeds of one dataset stand together
  std::vector<MethodConfig> methods;
  EvaluationConfig evaluation;
  std::size_t max_frames = 0;   ///< of each world; 0: all
  std::string resolved_config;  ///< YAML of the experiment; datasets and methods have their own

  OpenedDataset open(const World& world) const;
};

/// @param overrides  "dataset.KEY=VALUE" for every dataset, "methods.NAME.KEY=VALUE" for one
/// method,
///                   others for the experiment itself ("datasets.0.seeds=[1]", "evaluation.seed=2")
/// Throws InputError, also for what is wrong in the files of datasets (as far as can be told
/// without opening them) and methods.
ExperimentConfig readExperiment(const std::filesystem::path& config,
                                const std::vector<std::string>& overrides = {});

}  // namespace hydrabench

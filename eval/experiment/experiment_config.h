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
///       - config: ../datasets/office.yaml
///         name: office_many_misses     # in tables; without it the dataset's own
///         set: ["masks.miss_probability=0.3"]
///     methods:
///       - config: ../methods/hydra.yaml
///       - config: ../methods/hydra.yaml
///         name: hydra_tight
///         set: ["objects.cluster_tolerance_m=0.1"]
///     evaluation: {voxel_pitch_m: 0.05}
struct ExperimentConfig {
  /// A dataset, for generated ones with several seeds: worlds that are scored together.
  struct DatasetEntry {
    std::filesystem::path config;
    std::string name;  ///< empty: that of the dataset
    std::vector<std::string> overrides;
    std::vector<int> seeds;  ///< empty: the dataset as it is

    std::size_t numWorlds() const { return seeds.empty() ? 1 : seeds.size(); }
    /// World `index` below numWorlds(). Throws InputError.
    DatasetConfig read(std::size_t index) const;
  };
  std::string name;
  std::vector<DatasetEntry> datasets;
  std::vector<MethodConfig> methods;
  EvaluationConfig evaluation;
  std::size_t max_frames = 0;   ///< of each world; 0: all
  std::string resolved_config;  ///< YAML of the experiment; datasets and methods have their own
};

/// The list `datasets` of an experiment, which other studies have too.
/// @param overrides  key=value, for every dataset
std::vector<ExperimentConfig::DatasetEntry> readDatasetEntries(
    ConfigReader& reader, const std::vector<std::string>& overrides);

/// Throws InputError, also for what is wrong in the files of methods; a dataset's are read when it
/// is opened.
/// @param overrides  "dataset.KEY=VALUE" for every dataset, "methods.NAME.KEY=VALUE" for a method,
///                   others for the experiment itself ("datasets.0.seeds=[1]")
ExperimentConfig readExperiment(const std::filesystem::path& config,
                                const std::vector<std::string>& overrides = {});

}  // namespace hydrabench

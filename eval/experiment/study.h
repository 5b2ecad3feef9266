// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "eval/experiment/experiment_config.h"

namespace hydrabench {

/// One thing that a sweep turns.
struct SweepAxis {
  std::string name;                 ///< of the column: "voxel_size_m"
  std::string title;                ///< of the axis of a plot
  std::vector<std::string> values;  ///< as in YAML
  std::vector<std::string> set;     ///< KEY=VALUE for the experiment, {} standing for the value
};

/// An experiment, or the same experiment at every point of a grid:
///
///     name: voxel_size
///     experiment: ../experiments/robustness.yaml
///     axes:
///       - name: voxel_size_m
///         title: voxel size [m]
///         values: [0.05, 0.1, 0.2]
///         set: ["methods.hydra.tsdf.voxel_size_m={}", "methods.khronos.tsdf.voxel_size_m={}"]
///
/// `type: tau_o` and `method` instead of axes: the exact sweep of tau_o_sweep.h over the
/// candidates of one method of the experiment.
struct Study {
  struct Point {
    std::vector<std::string> values;  ///< per axis; none for a plain experiment
    ExperimentConfig experiment;
  };
  std::string name;
  std::string tau_o_method;  ///< empty: no sweep of tau_O
  std::vector<SweepAxis> axes;
  std::vector<Point> points;  ///< the last axis changes fastest
  std::string resolved_config;

  std::vector<ExperimentConfig> experiments() const;  ///< of the points
};

/// More runs than anybody starts without meaning to.
inline constexpr std::size_t kManyRuns = 10000;

/// @param overrides  as for readExperiment(), for every point; and the sweep's own keys
/// @param max_runs   a grid of more runs (points x methods x worlds) is refused before it is laid
///                   out; 0: no limit
Study readStudy(const std::filesystem::path& config, const std::vector<std::string>& overrides = {},
                std::size_t max_runs = kManyRuns);

}  // namespace hydrabench

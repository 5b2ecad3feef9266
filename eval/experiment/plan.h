// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "eval/experiment/experiment_config.h"
#include "eval/experiment/job.h"
#include "eval/experiment/unit_store.h"

namespace hydrabench {

/// Everything that a list of experiments needs done. What several of them need, or several methods
/// of one, is there once.
struct Plan {
  struct World {
    WorldSpec spec;
    std::vector<RunUnit> runs;
    std::vector<ScoreUnit> scores;
  };
  /// Where a number of a table comes from.
  struct Cell {
    std::string run;  ///< hashes
    std::string score;
  };
  struct PlannedWorld {
    std::size_t world = 0;    ///< index into worlds
    std::vector<Cell> cells;  ///< per method of the experiment
  };
  struct PlannedDataset {
    std::string name;
    std::vector<PlannedWorld> worlds;
  };
  using PlannedExperiment = std::vector<PlannedDataset>;

  std::vector<World> worlds;
  std::vector<PlannedExperiment> experiments;
};

/// What is measured of every frame.
enum class FrameCost { kTime, kInstructions };

/// Reads the configs of all datasets; generates and opens none. Throws InputError for a dataset or
/// file that is not there, and for two datasets of one name in an experiment.
/// @param cost  runs whose instructions are counted are others than those that are timed
Plan planOf(const std::vector<ExperimentConfig>& experiments, FrameCost cost = FrameCost::kTime);

/// What is not in the store yet, by world.
/// @param max_runs  that a job maps at once, at least 1
std::vector<Job> missingJobs(const Plan& plan, const UnitStore& store, std::size_t max_runs);

}  // namespace hydrabench

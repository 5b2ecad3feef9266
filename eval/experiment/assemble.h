// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "eval/experiment/plan.h"
#include "eval/report/result_folder.h"

namespace hydrabench {

/// What is not there, and why.
struct UnitFailure {
  std::string unit;  ///< "office, seed 3, hydra"
  std::string message;
  std::filesystem::path job;  ///< file that `hydrabench work` does again; empty: not tried yet
};

/// An experiment as far as it is done.
struct ExperimentOutcome {
  Result result;  ///< with everything that is in the store
  std::size_t predictions = 0;
  std::vector<UnitFailure> failures;
  std::map<std::string, double> frame_period_s;  ///< per dataset
};

/// kLeftOut: times, failures and config alone, for whoever has scores of its own.
enum class Scores { kAssembled, kLeftOut };

/// Gathers an experiment from the store: matches, scores and intervals are made from what the
/// scored pairs gave, worlds of a dataset also together. A function of the store's content.
ExperimentOutcome assembled(const ExperimentConfig& experiment,
                            const Plan::PlannedExperiment& planned, const Plan& plan,
                            const UnitStore& store, Scores scores = Scores::kAssembled);

/// Puts the predictions of an experiment into folder/predictions/DATASET/SEED/METHOD. Files that
/// stand in the store are linked, or copied where the file system cannot.
void linkPredictions(const ExperimentConfig& experiment, const Plan::PlannedExperiment& planned,
                     const Plan& plan, const UnitStore& store, const std::filesystem::path& folder);

}  // namespace hydrabench

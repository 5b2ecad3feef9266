// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <string>

#include "eval/training/crisp_training_config.h"

namespace hydrabench {

/// Progress of a training: phase, step, all steps, numbers to show.
using TrainingProgress = std::function<void(const std::string& phase, int step, int steps,
                                            const std::map<std::string, double>& numbers)>;
/// True when it is time to stop; what was done is in the checkpoint.
using StopRequest = std::function<bool()>;

enum class TrainingState { kNoNetworkYet, kStopped, kFinished };

/// Trains the small CRISP network in `out`, or goes on with it: out/worlds (cache), checkpoints,
/// loss.csv, config.yaml, and out/model with manifest and weights, ready for an estimator, as they
/// are at the end of the call. Throws InputError where `out` holds a training of another config.
TrainingState trainCrispModel(const CrispTrainingConfig& config, const std::string& resolved,
                              const std::filesystem::path& out, const TrainingProgress& progress,
                              const StopRequest& stop);

}  // namespace hydrabench

// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

#include "eval/training/crisp_training.h"
#include "eval/training/latent_flow_training_config.h"

namespace hydrabench {

/// Trains the latent flow in `out`, or goes on with it: out/worlds (cache), checkpoints, loss.csv,
/// config.yaml, and out/model with manifest and weights, ready for an estimator, as they are at the
/// end of the call. Throws InputError where `out` holds a training of another config.
TrainingState trainLatentFlow(const LatentFlowTrainingConfig& config, const std::string& resolved,
                              const std::filesystem::path& out, const TrainingProgress& progress,
                              const StopRequest& stop);

}  // namespace hydrabench

// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

#include "eval/training/latent_flow_training_config.h"
#include "tests/eval/training/toy_world.h"

namespace hydrabench {

/// Networks and phases so small that a step takes milliseconds; worlds from cacheToyFlowWorlds().
inline LatentFlowTrainingConfig toyFlowTraining() {
  LatentFlowTrainingConfig config;
  for (auto* heads : {&config.network.autoencoder_heads, &config.network.flow_heads,
                      &config.network.pose_heads, &config.network.view_heads}) {
    *heads = 2;
  }
  for (auto* dim : {&config.network.autoencoder_dim, &config.network.flow_dim,
                    &config.network.pose_dim, &config.network.view_dim}) {
    *dim = 16;
  }
  for (auto* depth :
       {&config.network.encoder_depth, &config.network.decoder_depth, &config.network.flow_depth,
        &config.network.pose_depth, &config.network.view_depth}) {
    *depth = 1;
  }
  config.network.latent = config.network.features = 4;
  config.network.hidden = 8;
  for (FlowPhaseConfig* phase : {static_cast<FlowPhaseConfig*>(&config.autoencoder),
                                 static_cast<FlowPhaseConfig*>(&config.pose),
                                 static_cast<FlowPhaseConfig*>(&config.shape)}) {
    phase->steps = 3;
    phase->batch = 4;
    phase->warmup_steps = 2;
  }
  config.autoencoder.points = 16;
  config.rooms.worlds.grid_frames = 1;
  config.rooms.count = 2;
  config.rooms.validation = 1;
  config.streets.count = config.streets.validation = 0;
  config.checkpoint_every = 1000;
  config.precision = "fp32";
  return config;
}

inline void cacheToyFlowWorlds(const std::filesystem::path& cache,
                               const LatentFlowTrainingConfig& config) {
  cacheToyWorlds(cache / "rooms", config.rooms.worlds);
}

}  // namespace hydrabench

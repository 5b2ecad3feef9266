// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "eval/training/crisp_trainer.h"
#include "tests/eval/training/toy_world.h"

namespace hydrabench {

/// A network and phases so small that a step takes milliseconds; worlds from cacheToyWorlds().
inline CrispTrainingConfig toyTraining() {
  CrispTrainingConfig config;
  config.network = {.dim = 16, .depth = 1, .heads = 2, .decoder_layers = 2, .decoder_width = 16};
  config.decoder.worlds = 2;
  config.decoder.steps = 5;
  config.decoder.shapes_per_step = 4;
  config.decoder.points_per_shape = 16;
  config.joint.worlds = 2;
  config.joint.window = 1;
  config.joint.steps = 5;
  config.joint.batch = 4;
  config.joint.sdf_points = 16;
  config.joint.warmup_steps = 2;
  config.validation_worlds = 1;
  config.checkpoint_every = 1000;
  config.precision = "fp32";
  return config;
}

inline std::vector<TrainingSample> toySamples(std::uint64_t count) {
  const TrainingWorld world = toyWorld(1);
  std::vector<TrainingSample> samples;
  for (std::uint64_t i = 0; i < count; ++i) {
    const TrainingView& view = world.views[(5 * i) % world.views.size()];
    samples.push_back(makeTrainingSample(world.shapes[view.shape], view, 32, 1, Random(i)));
    samples.back().shape = view.shape;
  }
  return samples;
}

}  // namespace hydrabench

// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/evaluation/evaluation_config.h"

#include <algorithm>

namespace hydrabench {

ObjectModel::Config EvaluationConfig::modelConfig() const {
  ObjectModel::Config config;
  config.samples = static_cast<std::size_t>(samples);
  config.grid.pitch_m = voxel_pitch_m;
  config.jittered_origins = static_cast<std::size_t>(jittered_origins);
  config.seed = seed;
  return config;
}

BootstrapConfig EvaluationConfig::bootstrapConfig() const {
  BootstrapConfig config;
  config.resamples = bootstrap_resamples;
  config.seed = seed;
  return config;
}

void read(ConfigReader& reader, EvaluationConfig& config) {
  reader.field("thresholds_m", config.thresholds_m, {1e-6, 1e3});
  reader.field("kappas", config.kappas, {1e-6, 1e3});
  reader.field("kappa_max", config.kappa_max, {1e-6, 1e3});
  reader.field("samples", config.samples, {1, 10'000'000});
  reader.field("voxel_pitch_m", config.voxel_pitch_m, {1e-3, 10});
  reader.field("jittered_origins", config.jittered_origins, {0, 1000});
  reader.field("bootstrap_resamples", config.bootstrap_resamples, {0, 1'000'000});
  reader.field("seed", config.seed);
  reader.field("min_visible_fraction", config.min_visible_fraction, {0, 1});
  auto scene = reader.section("scene");
  read(scene, config.scene);
  if (config.thresholds_m.empty())
    reader.fault("thresholds_m", "empty, expected at least one threshold");
}

std::string toYaml(EvaluationConfig config) {
  ConfigReader reader(ConfigDocument::fromString("{}"));
  read(reader, config);
  return reader.resolved();
}

}  // namespace hydrabench

// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/training/crisp_training_config.h"

#include <fmt/format.h>

namespace hydrabench {
namespace {

void read(ConfigReader& reader, CrispTrainingConfig::Network& network) {
  reader.field("dim", network.dim, {8, 4096});
  reader.field("depth", network.depth, {1, 64});
  reader.field("heads", network.heads, {1, 64});
  reader.field("decoder_layers", network.decoder_layers, {1, 16});
  reader.field("decoder_width", network.decoder_width, {8, 2048});
  if (network.dim % network.heads != 0) {
    reader.fault("heads", fmt::format("{} heads do not divide dim {}, expected a divisor",
                                      network.heads, network.dim));
  }
}

void read(ConfigReader& reader, CrispTrainingConfig::Decoder& decoder) {
  reader.field("worlds", decoder.worlds, {1, 100000});
  reader.field("steps", decoder.steps, {1, 1e8});
  reader.field("shapes_per_step", decoder.shapes_per_step, {1, 10000});
  reader.field("points_per_shape", decoder.points_per_shape, {1, 100000});
  reader.field("learning_rate", decoder.learning_rate, {1e-8, 1});
  reader.field("code_learning_rate", decoder.code_learning_rate, {1e-8, 1});
  reader.field("code_deviation", decoder.code_deviation, {0, 10});
  reader.field("code_penalty", decoder.code_penalty, {0, 1});
}

void read(ConfigReader& reader, CrispTrainingConfig::Joint& joint) {
  reader.field("worlds", joint.worlds, {1, 100000});
  reader.field("window_worlds", joint.window, {1, 100000});
  reader.field("steps", joint.steps, {1, 1e8});
  reader.field("batch", joint.batch, {1, 100000});
  reader.field("sdf_points", joint.sdf_points, {1, 100000});
  reader.field("learning_rate", joint.learning_rate, {1e-8, 1});
  reader.field("decoder_learning_rate_share", joint.decoder_learning_rate_share, {0, 1});
  reader.field("weight_decay", joint.weight_decay, {0, 1});
  reader.field("warmup_steps", joint.warmup_steps, {1, 1e8});
  reader.field("average_decay", joint.average_decay, {0, 1});
  reader.field("nocs_weight", joint.nocs_weight, {0, 1e6});
  reader.field("sdf_weight", joint.sdf_weight, {0, 1e6});
  reader.field("direct_weight", joint.direct_weight, {0, 1e6});
  reader.field("code_weight", joint.code_weight, {0, 1e6});
}

}  // namespace

void CrispTrainingConfig::useStreetClasses() {
  class_weights = {{"bench", 0.35}, {"car", 0.35}, {"fire_hydrant", 0.3}};
  sdf_quantiles = {{"bench", 0.35}, {"car", 0.35}, {"fire_hydrant", 0.35}};
}

void read(ConfigReader& reader, CrispTrainingConfig& config) {
  reader.field("seed", config.seed);
  reader.path("start_from", config.start_from);
  auto worlds = reader.section("worlds");
  read(worlds, config.worlds);
  if (config.worlds.world == "street") config.useStreetClasses();
  auto weights = reader.section("class_weights");
  for (auto& [name, weight] : config.class_weights) weights.field(name, weight, {0, 1e6});
  auto quantiles = reader.section("sdf_quantiles");
  for (auto& [name, quantile] : config.sdf_quantiles) quantiles.field(name, quantile, {0.01, 0.99});
  auto network = reader.section("network");
  read(network, config.network);
  auto decoder = reader.section("decoder");
  read(decoder, config.decoder);
  auto joint = reader.section("joint");
  read(joint, config.joint);
  reader.field("target_clamp", config.target_clamp, {0.01, 2});
  reader.field("shards", config.shards, {1, 64});
  reader.choice("precision", config.precision, {"auto", "bf16", "fp32"});
  reader.field("validation_worlds", config.validation_worlds, {1, 1000});
  reader.field("validation_every_steps", config.validation_every, {1, 1e8});
  reader.field("checkpoint_every_steps", config.checkpoint_every, {1, 1e8});
  if (config.joint.batch % config.shards != 0 ||
      config.decoder.shapes_per_step % config.shards != 0) {
    reader.fault("shards", fmt::format("{} does not divide joint.batch and "
                                       "decoder.shapes_per_step, expected a divisor of both",
                                       config.shards));
  }
}

}  // namespace hydrabench

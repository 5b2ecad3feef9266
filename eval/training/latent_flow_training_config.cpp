// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/training/latent_flow_training_config.h"

#include <fmt/format.h>

namespace hydrabench {
namespace {

void read(ConfigReader& reader, LatentFlowTrainingConfig::Source& source) {
  reader.field("count", source.count, {0, 100000});
  reader.field("validation", source.validation, {0, 1000});
  read(reader, source.worlds);
  if (source.worlds.grid_frames < 1) {
    reader.fault("grid_frames", "0 grids per shape, expected at least 1");
  }
}

void read(ConfigReader& reader, FlowPhaseConfig& phase, int shards) {
  reader.field("steps", phase.steps, {0, 1e8});
  reader.field("batch", phase.batch, {1, 100000});
  reader.field("learning_rate", phase.learning_rate, {1e-8, 1});
  reader.field("warmup_steps", phase.warmup_steps, {1, 1e8});
  reader.field("weight_decay", phase.weight_decay, {0, 1});
  if (phase.batch % shards != 0) {
    reader.fault("batch", fmt::format("{} is no multiple of the {} shards, expected one",
                                      phase.batch, shards));
  }
}

}  // namespace

LatentFlowTrainingConfig::LatentFlowTrainingConfig() {
  for (Source* source : {&rooms, &streets}) {
    source->worlds.objects = "all";
    source->worlds.frames = 500;
    source->worlds.max_views_per_shape = 32;
    source->worlds.sdf_points = 6000;
    source->worlds.grid_frames = 3;
  }
  rooms.count = 60;
  rooms.validation = 2;
  streets.count = 20;
  streets.validation = 1;
  streets.worlds.world = "street";
  streets.worlds.max_depth_m = 12;
}

void read(ConfigReader& reader, LatentFlowTrainingConfig& config) {
  reader.field("seed", config.seed);
  reader.path("start_from", config.start_from);
  reader.path("view_encoder_from", config.view_encoder_from);
  reader.field("shards", config.shards, {1, 64});
  auto rooms = reader.section("rooms");
  read(rooms, config.rooms);
  auto streets = reader.section("streets");
  read(streets, config.streets);
  auto weights = reader.section("class_weights");
  for (auto& [name, weight] : config.class_weights) weights.field(name, weight, {0, 1e6});
  auto network = reader.section("network");
  read(network, config.network);
  auto autoencoder = reader.section("autoencoder");
  read(autoencoder, config.autoencoder, config.shards);
  autoencoder.field("points", config.autoencoder.points, {1, 100000});
  autoencoder.field("latent_noise", config.autoencoder.latent_noise, {0, 10});
  autoencoder.field("latent_penalty", config.autoencoder.latent_penalty, {0, 10});
  auto pose = reader.section("pose");
  read(pose, config.pose, config.shards);
  auto shape = reader.section("shape");
  read(shape, config.shape, config.shards);
  shape.field("condition_dropout", config.shape.condition_dropout, {0, 1});
  reader.field("average_decay", config.average_decay, {0, 1});
  reader.choice("precision", config.precision, {"auto", "bf16", "fp32"});
  reader.field("validation_every_steps", config.validation_every, {1, 1e8});
  reader.field("checkpoint_every_steps", config.checkpoint_every, {1, 1e8});
}

}  // namespace hydrabench

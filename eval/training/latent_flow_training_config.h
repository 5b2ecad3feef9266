// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>

#include "core/config/config_reader.h"
#include "core/shape/latent_flow/latent_flow_manifest.h"
#include "eval/training/training_world.h"

namespace hydrabench {

/// How one of the networks of the latent flow is trained.
struct FlowPhaseConfig {
  int steps = 10000;
  int batch = 32;
  double learning_rate = 1e-3;
  int warmup_steps = 300;
  double weight_decay = 1e-2;
};

/// How the latent flow is trained (configs/training/latent_flow.yaml): the autoencoder of shapes,
/// then the flow of poses and the flow of latent shapes.
struct LatentFlowTrainingConfig {
  std::uint64_t seed = 1;
  /// Folder of an earlier latent flow of the same sizes to begin with; empty: random weights.
  std::filesystem::path start_from;
  /// Folder of a small CRISP model; the encoder of views begins with its weights. Empty: random
  /// ones. Of no effect with start_from.
  std::filesystem::path view_encoder_from;

  /// Worlds of one kind and how many of them; all of them are held in memory.
  struct Source {
    TrainingWorldConfig worlds;
    int count = 0;
    int validation = 0;
  };
  Source rooms;    ///< offices with all that stands in them
  Source streets;  ///< streets with all that stands there
  /// Every class of what stands in rooms and streets, by its label: how often a view of it is
  /// drawn.
  std::map<std::string, double> class_weights = {
      {"bench", 1},   {"bin", 1.2},    {"bollard", 0.2},    {"cabinet", 1.2}, {"car", 1},
      {"chair", 2},   {"computer", 3}, {"couch", 1.2},      {"cubicle", 0.1}, {"desk", 1.2},
      {"plant", 1.2}, {"sign", 0.2},   {"fire_hydrant", 1}, {"lamp_pole", 0}, {"tree", 0}};

  LatentFlowSizes network;
  struct Autoencoder : FlowPhaseConfig {
    int points = 256;              ///< distances per shape
    double latent_noise = 0.1;     ///< on the latents while the decoder learns
    double latent_penalty = 1e-3;  ///< on their squares: they stay of about size 1
  } autoencoder;
  struct Pose : FlowPhaseConfig {
  } pose;
  struct Shape : FlowPhaseConfig {
    double condition_dropout = 0.1;  ///< share of views that are not shown: for guidance
  } shape;

  double average_decay = 0.999;  ///< of the exponential average of the weights that is shipped
  int shards = 2;  ///< parts of a batch that are computed side by side; changes results
  std::string precision = "auto";  ///< bf16, fp32; auto: bf16 where the CPU multiplies it
  int validation_every = 1000;     ///< steps
  int checkpoint_every = 500;

  LatentFlowTrainingConfig();
};
void read(ConfigReader& reader, LatentFlowTrainingConfig& config);

}  // namespace hydrabench

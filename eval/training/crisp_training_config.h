// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>

#include "core/config/config_reader.h"
#include "eval/training/training_world.h"

namespace hydrabench {

/// How the small CRISP network is trained (configs/training/*.yaml).
struct CrispTrainingConfig {
  std::uint64_t seed = 1;
  /// Model folder whose weights the network begins with, of the same sizes; empty: random ones.
  std::filesystem::path start_from;
  TrainingWorldConfig worlds;
  /// Of the world's classes: those of rooms unless said otherwise.
  std::map<std::string, double> class_weights = {
      {"bin", 0.2}, {"chair", 0.35}, {"couch", 0.22}, {"plant", 0.23}};

  /// Which quantile of the distance is learned, given the view. With the median a part is there if
  /// it is more likely there than not: thin legs, whose place is not quite known, vanish. Overlap
  /// is best where what has a chance of IoU / (1 + IoU) is there; leaves have the least.
  std::map<std::string, double> sdf_quantiles = {
      {"bin", 0.35}, {"chair", 0.35}, {"couch", 0.35}, {"plant", 0.2}};

  struct Network {
    int dim = 192;
    int depth = 6;
    int heads = 3;
    int decoder_layers = 4;
    int decoder_width = 128;
  } network;

  /// First the decoder alone, with a code of its own for every shape (auto-decoder, Park et al.,
  /// CVPR 2019): trained jointly from images it stays blurred.
  struct Decoder {
    int worlds = 40;
    int steps = 12000;
    int shapes_per_step = 40;
    int points_per_shape = 384;
    double learning_rate = 3e-3;
    double code_learning_rate = 4e-2;
    double code_deviation = 0.01;  ///< of the codes it begins with: noise that stays, if large
    double code_penalty = 1e-4;
  } decoder;

  /// Then all together.
  struct Joint {
    int worlds = 120;
    int window = 40;  ///< worlds in memory at a time; the window moves on through all of them
    int steps = 60000;
    int batch = 32;
    int sdf_points = 256;
    double learning_rate = 1e-3;
    double decoder_learning_rate_share = 0.3;
    double weight_decay = 1e-2;
    int warmup_steps = 500;
    double average_decay = 0.999;  ///< of the exponential average of the weights that is shipped
    double nocs_weight = 2;
    double sdf_weight = 20;
    double direct_weight = 1;
    double code_weight = 0.5;
  } joint;

  double target_clamp = 0.25;  ///< of distances, object coordinates
  int shards = 2;              ///< parts of a batch that are computed side by side; changes results
  std::string precision =
      "auto";  ///< bf16, fp32; auto: bf16 where the CPU multiplies it in hardware
  int validation_worlds = 4;
  int validation_every = 1000;  ///< steps
  int checkpoint_every = 500;

  /// Weights and quantiles for the classes of the world "street".
  void useStreetClasses();
};
void read(ConfigReader& reader, CrispTrainingConfig& config);

}  // namespace hydrabench

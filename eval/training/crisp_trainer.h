// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
//
// Includes libtorch: for the sources of the trainers only.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <span>
#include <string>

#include "core/shape/crisp/point_network.h"
#include "eval/training/crisp_training.h"
#include "eval/training/shape_decoder_trainer.h"
#include "eval/training/training_pool.h"

namespace hydrabench {

/// Samples as tensors.
struct TrainingBatch {
  PointBatch input;
  torch::Tensor nocs;                ///< [B, poses, kObjectPoints, 3]
  torch::Tensor weights;             ///< [B, kObjectPoints]
  torch::Tensor direct;              ///< [B, poses, 6]
  torch::Tensor points;              ///< [B, n, 3]
  torch::Tensor distances;           ///< [B, n]
  torch::Tensor code_rows;           ///< [B], -1 where there is no code
  std::vector<std::string> classes;  ///< B names
};
TrainingBatch makeTrainingBatch(std::span<const TrainingSample> samples, const ShapeCodes& codes);

/// A loss and what it is made of.
struct CrispLoss {
  torch::Tensor total;
  double nocs = 0;  ///< this and the rest: unweighted. Mean over points of the sum over x, y, z
  double nocs_error = 0;  ///< mean distance in object coordinates
  double sdf = 0;
  double direct = 0;
  double code = 0;
};
CrispLoss crispLoss(const CrispTrainingConfig& config, PointNetwork network,
                    const TrainingBatch& batch, const ShapeCodes& codes);

/// Options of the network a config describes.
PointNetworkImpl::Options networkOptions(const CrispTrainingConfig& config);

/// Trains in `out`: worlds in out/worlds, checkpoints, loss.csv. Goes on from where an earlier call
/// stopped. `network` gets the averaged weights as they are at the end of the call; with
/// kNoNetworkYet it is untrained.
TrainingState trainCrisp(const CrispTrainingConfig& config, const std::filesystem::path& out,
                         PointNetwork network, const TrainingProgress& progress,
                         const StopRequest& stop);

}  // namespace hydrabench

// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
//
// Includes libtorch: for the sources of the trainers only.
#pragma once

#include <filesystem>
#include <map>
#include <optional>

#include "core/shape/crisp/point_network.h"
#include "eval/training/crisp_training.h"
#include "eval/training/training_pool.h"

namespace hydrabench {

/// Decoder, modulation and a code per shape, trained on distances alone.
struct ShapeCodes {
  torch::Tensor codes;                        ///< [S, code]; undefined where there are none
  double variance = 1;                        ///< of the codes, mean over dimensions
  std::map<std::int64_t, std::int64_t> rows;  ///< number of a shape -> row
};

/// Trains network->decoder() and network->modulation(). Keeps out/decoder.checkpoint, from
/// which it goes on, and its lines in out/loss.csv.
/// @return  codes of the shapes that have a front; nullopt if asked to stop
std::optional<ShapeCodes> trainShapeDecoder(const CrispTrainingConfig& config,
                                            const TrainingPool& pool, PointNetwork network,
                                            const std::filesystem::path& out,
                                            const TrainingProgress& progress,
                                            const StopRequest& stop);

}  // namespace hydrabench

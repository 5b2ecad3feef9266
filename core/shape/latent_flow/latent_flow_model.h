// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>

#include "core/shape/crisp/point_input.h"
#include "core/shape/latent_flow/view_grid.h"
#include "core/shape/sdf_mesher.h"

namespace hydrabench {

/// The networks of a latent flow with their weights; LatentFlowEstimator does the rest. Thread-safe
/// and a function of the arguments.
class LatentFlowModel {
 public:
  virtual ~LatentFlowModel() = default;
  /// Draws `samples` frames of the object from what the view leaves open, and gives the one that is
  /// nearest to all others: where several yaws look the same, one of them, not their mean.
  /// @return  in the level frame; not finite where the weights are not
  virtual LocalFrame drawPose(const PointInput& view, int samples, int steps,
                              std::uint64_t seed) const = 0;
  /// Draws a shape.
  /// @return  distances in the frame that the view was gathered in, and in its units
  virtual SdfField drawShape(const ViewGrid& view, double guidance, int steps,
                             std::uint64_t seed) const = 0;
};

/// @param manifest  a manifest, or a folder with a manifest.yaml in it
/// @param device    cpu | cuda
/// Throws InputError for what is wrong with manifest, weights or device.
std::unique_ptr<const LatentFlowModel> loadLatentFlowModel(const std::filesystem::path& manifest,
                                                           const std::string& device);

}  // namespace hydrabench

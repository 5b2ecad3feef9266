// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <vector>

#include "core/shape/shape_estimator.h"
#include "eval/oracles/true_instances.h"

namespace hydrabench {

/// True shape and pose of whatever the mask mostly shows: an upper bound of every estimator. The
/// mesh is that of the ground truth in normalised coordinates: the centre of its box at the origin,
/// its largest half extent 1.
class ShapeOracle : public ShapeEstimator {
 public:
  static constexpr const char* kNoObject = "the mask shows no object";

  explicit ShapeOracle(std::shared_ptr<const TrueInstances> truth);

  /// One view is enough: `others` and `seed` do not matter.
  ShapeOutcome estimate(const ShapeObservation& best, std::span<const ShapeObservation> others,
                        std::uint64_t seed) const override;

 private:
  /// A ground-truth mesh in normalised coordinates.
  struct Shape {
    Mesh mesh;
    Eigen::Vector3d center = Eigen::Vector3d::Zero();  ///< of its box, object frame [m]
    double scale = 1;                                  ///< its largest half extent [m]
  };
  std::shared_ptr<const TrueInstances> truth_;
  std::vector<Shape> shapes_;
};

}  // namespace hydrabench

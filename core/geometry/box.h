// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Geometry>

namespace hydrabench {

/// Axis-aligned box [m]. Empty when default-constructed.
using Aabb = Eigen::AlignedBox3d;

/// Volume of the intersection over volume of the union, in [0, 1]. Two boxes without volume that
/// are equal: 1; otherwise a union without volume gives 0.
double boxIou(const Aabb& a, const Aabb& b);

/// Half the length of the diagonal [m]; the d_diag of the kappa-normalised threshold.
double halfDiagonal(const Aabb& box);

/// Box of any orientation.
struct OrientedBox {
  Eigen::Isometry3d T_world_box = Eigen::Isometry3d::Identity();  ///< origin at the box centre
  Eigen::Vector3d dimensions = Eigen::Vector3d::Zero();           ///< full edge lengths [m]

  double volume() const { return dimensions.prod(); }
};

/// Exact: the intersection polytope is clipped face by face, no sampling. Degenerate boxes as in
/// boxIou.
double orientedBoxIou(const OrientedBox& a, const OrientedBox& b);

}  // namespace hydrabench

// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "core/geometry/transform.h"
#include "eval/simulation/shape_family.h"

namespace hydrabench {

/// A distance field somewhere in the world, with a box around it (world frame).
struct PlacedSdf {
  const Sdf* sdf = nullptr;
  Transform T_world_sdf = Transform::Identity();
  Aabb box;
};

/// True where some point lies deeper than `tolerance` [m] inside both. A negative tolerance asks
/// for a gap; the boxes must then be wider than the shapes by as much. Searches an octree of the
/// common box and prunes by the distances, so it costs little unless the surfaces run close to each
/// other.
bool interpenetrate(const PlacedSdf& a, const PlacedSdf& b, double tolerance);

/// Box around the shape in its own frame, each side within `tolerance` [m] outside of the surface.
/// Sdf::bounds() may be loose.
Aabb tightBounds(const Sdf& sdf, double tolerance = 0.004);

/// Height of the highest surface point below `from`, nullopt if there is none above z = 0. Frame of
/// the shape.
std::optional<double> heightBelow(const Sdf& sdf, const Eigen::Vector3d& from);

}  // namespace hydrabench

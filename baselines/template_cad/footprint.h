// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>
#include <vector>

#include <Eigen/Core>

namespace hydrabench {

/// Rectangle around points on the floor, turned to their main axes.
struct Footprint {
  Eigen::Vector2d center = Eigen::Vector2d::Zero();  ///< middle of the extents [m]
  double yaw = 0;     ///< of the longer axis, in [0, pi): a footprint has no front [rad]
  double length = 0;  ///< extent along the longer axis [m]
  double width = 0;   ///< extent across it [m]
};

/// Convex hull of the points' x and y, counter-clockwise, without points on its edges (Andrew's
/// monotone chain).
std::vector<Eigen::Vector2d> convexHull(std::span<const Eigen::Vector3d> points);

/// Main axes of the area of the convex hull in x and y, and the extents along them. Unlike axes of
/// the hull's corners or of the points they do not depend on how densely a side was sampled.
/// nullopt where the points do not span an area.
std::optional<Footprint> footprintOf(std::span<const Eigen::Vector3d> points);

}  // namespace hydrabench

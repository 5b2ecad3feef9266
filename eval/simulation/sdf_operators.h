// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include <Eigen/Core>

#include "core/geometry/transform.h"
#include "eval/simulation/sdf.h"

namespace hydrabench {

/// Operators on signed distances. Each keeps the Lipschitz constant of 1: minima, maxima and convex
/// blends of such functions, and rigid motions.

/// Children far away are skipped by their boxes; the value does not depend on the order.
SdfPtr unite(std::vector<SdfPtr> children);
/// Quadratic blend; surfaces closer than `blend` [m] in value flow into each other.
SdfPtr smoothUnion(SdfPtr a, SdfPtr b, double blend);
SdfPtr intersect(SdfPtr a, SdfPtr b);
/// Intersection with rounded edges; the shape keeps within both.
SdfPtr smoothIntersection(SdfPtr a, SdfPtr b, double blend);
SdfPtr subtract(SdfPtr from, SdfPtr what);
/// The skin of a shape: all points inside it and within `thickness` of its surface (as the tree
/// measures it).
SdfPtr shell(SdfPtr shape, double thickness);

/// All points within `distance` [m] of the shape: edges become round.
SdfPtr inflated(SdfPtr shape, double distance);

SdfPtr placed(const Transform& T_parent_child, SdfPtr child);
SdfPtr moved(SdfPtr child, const Eigen::Vector3d& translation);
/// Turned around an axis through the origin, then moved.
SdfPtr turned(SdfPtr child, const Eigen::Vector3d& axis, double angle_rad,
              const Eigen::Vector3d& translation = Eigen::Vector3d::Zero());

/// Chain of tapered capsules with a radius at every point: a bent tube or stem.
SdfPtr tube(const std::vector<Eigen::Vector3d>& points, const std::vector<double>& radii);

}  // namespace hydrabench

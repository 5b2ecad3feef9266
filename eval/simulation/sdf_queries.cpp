// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/simulation/sdf_queries.h"

#include <algorithm>

namespace hydrabench {
namespace {

constexpr double kSmallestCell_m = 0.004;

Aabb octant(const Aabb& box, int which) {
  const Eigen::Vector3d middle = box.center();
  Eigen::Vector3d low = box.min();
  Eigen::Vector3d high = box.max();
  for (int axis = 0; axis < 3; ++axis) {
    (which >> axis & 1 ? low : high)[axis] = middle[axis];
  }
  return {low, high};
}

bool overlapIn(const Aabb& cell, const PlacedSdf& a, const Transform& T_a_world, const PlacedSdf& b,
               const Transform& T_b_world, double tolerance) {
  const Eigen::Vector3d center = cell.center();
  const double radius = 0.5 * cell.diagonal().norm();
  const double depth_a = a.sdf->value(T_a_world * center);
  if (depth_a > radius - tolerance) return false;
  const double depth_b = b.sdf->value(T_b_world * center);
  if (depth_b > radius - tolerance) return false;
  if (std::max(depth_a, depth_b) < -tolerance) return true;
  if (radius < kSmallestCell_m) return false;
  for (int i = 0; i < 8; ++i) {
    if (overlapIn(octant(cell, i), a, T_a_world, b, T_b_world, tolerance)) return true;
  }
  return false;
}

/// Grows `found` by the cells that may hold surface or inside, skipping those that cannot enlarge
/// it.
void growBounds(const Sdf& sdf, const Aabb& cell, double tolerance, Aabb& found) {
  if (!found.isEmpty() && found.contains(cell)) return;
  const double radius = 0.5 * cell.diagonal().norm();
  const double value = sdf.value(cell.center());
  if (value > radius) return;
  if (value <= 0 && radius > tolerance) found.extend(cell.center());
  if (radius <= tolerance) {
    found.extend(cell);
    return;
  }
  for (int i = 0; i < 8; ++i) growBounds(sdf, octant(cell, i), tolerance, found);
}

}  // namespace

bool interpenetrate(const PlacedSdf& a, const PlacedSdf& b, double tolerance) {
  const Aabb common = a.box.intersection(b.box);
  if (common.isEmpty()) return false;
  return overlapIn(common, a, a.T_world_sdf.inverse(), b, b.T_world_sdf.inverse(), tolerance);
}

Aabb tightBounds(const Sdf& sdf, double tolerance) {
  Aabb found;
  growBounds(sdf, sdf.bounds(), tolerance, found);
  return found;
}

std::optional<double> heightBelow(const Sdf& sdf, const Eigen::Vector3d& from) {
  Eigen::Vector3d p = from;
  while (p.z() > 0) {
    const double value = sdf.value(p);
    if (value < 1e-4) return p.z();
    p.z() -= value;
  }
  return std::nullopt;
}

}  // namespace hydrabench

// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/simulation/sdf_queries.h"

#include <algorithm>
#include <limits>
#include <queue>

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

/// How far the shape reaches along one axis (sign +1 or -1), searched best first: the cell that
/// could reach farthest is looked into next, of equal ones the smallest.
double reach(const Sdf& sdf, int axis, double sign, double tolerance) {
  struct Cell {
    Aabb box;
    double extreme;
    double radius;
    bool operator<(const Cell& other) const {
      return extreme != other.extreme ? extreme < other.extreme : radius > other.radius;
    }
  };
  std::priority_queue<Cell> open;
  double reached = -std::numeric_limits<double>::infinity();  // by a point known to be inside
  const auto consider = [&](const Aabb& box) {
    const double radius = 0.5 * box.diagonal().norm();
    const double value = sdf.value(box.center());
    if (value > radius) return;
    if (value <= 0) reached = std::max(reached, sign * box.center()[axis] - value);
    open.push({box, sign * (sign > 0 ? box.max() : box.min())[axis], radius});
  };
  consider(sdf.bounds());
  while (!open.empty()) {
    const Cell cell = open.top();
    open.pop();
    if (cell.radius <= tolerance || cell.extreme - reached <= tolerance) return sign * cell.extreme;
    for (int i = 0; i < 8; ++i) consider(octant(cell.box, i));
  }
  return 0;  // an empty shape
}

}  // namespace

bool interpenetrate(const PlacedSdf& a, const PlacedSdf& b, double tolerance) {
  const Aabb common = a.box.intersection(b.box);
  if (common.isEmpty()) return false;
  return overlapIn(common, a, a.T_world_sdf.inverse(), b, b.T_world_sdf.inverse(), tolerance);
}

Aabb tightBounds(const Sdf& sdf, double tolerance) {
  Aabb box;
  for (int axis = 0; axis < 3; ++axis) {
    box.min()[axis] = reach(sdf, axis, -1, tolerance);
    box.max()[axis] = reach(sdf, axis, 1, tolerance);
  }
  return box;
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

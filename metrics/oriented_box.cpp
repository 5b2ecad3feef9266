// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "metrics/oriented_box.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "core/geometry/mesh_repair.h"
#include "core/types/error.h"
#include "metrics/detection.h"

namespace hydrabench {
namespace {

using Points = std::vector<Eigen::Vector3d>;

constexpr int kDirections = 100;  // each with its opposite

Points usedVertices(const Mesh& mesh) {
  std::vector<bool> used(mesh.vertices.size());
  for (const Eigen::Vector3i& face : mesh.faces) {
    for (const int vertex : face) used[static_cast<std::size_t>(vertex)] = true;
  }
  Points points;
  for (std::size_t i = 0; i < used.size(); ++i) {
    if (used[i]) points.push_back(mesh.vertices[i]);
  }
  return points;
}

/// The first and last points along directions spread evenly over a hemisphere (a Fibonacci spiral).
Points extremePoints(const Points& points) {
  if (points.size() <= 2 * kDirections) return points;
  std::vector<std::size_t> extremes;
  for (int i = 0; i < kDirections; ++i) {
    const double z = (i + 0.5) / kDirections;
    const double angle = i * std::numbers::pi * (3 - std::sqrt(5.0));
    const double radius = std::sqrt(1 - z * z);
    const Eigen::Vector3d direction(radius * std::cos(angle), radius * std::sin(angle), z);
    std::size_t first = 0, last = 0;
    double low = direction.dot(points[0]), high = low;
    for (std::size_t p = 1; p < points.size(); ++p) {
      const double along = direction.dot(points[p]);
      if (along < low) low = along, first = p;
      if (along > high) high = along, last = p;
    }
    extremes.push_back(first);
    extremes.push_back(last);
  }
  std::sort(extremes.begin(), extremes.end());
  extremes.erase(std::unique(extremes.begin(), extremes.end()), extremes.end());
  Points result;
  for (const std::size_t p : extremes) result.push_back(points[p]);
  return result;
}

/// The box with the given axes around all points.
OrientedBox boxAlong(const Eigen::Matrix3d& axes, const Points& points) {
  Aabb extent;
  for (const Eigen::Vector3d& point : points) extent.extend(axes.transpose() * point);
  OrientedBox box;
  box.T_world_box.linear() = axes;
  box.T_world_box.translation() = axes * extent.center();
  box.dimensions = extent.sizes();
  return box;
}

}  // namespace

OrientedBox objectOrientedBox(const Mesh& mesh_world) {
  const Points points = usedVertices(mesh_world);
  if (points.empty()) return OrientedBox();
  const OrientedBox aligned = boxAlong(Eigen::Matrix3d::Identity(), points);
  Mesh extremes;
  extremes.vertices = extremePoints(points);
  try {
    const OrientedBox turned = boxAlong(smallestBox(extremes).T_world_box.linear(), points);
    // The optimiser may end a little above a box that is aligned already.
    return turned.volume() < aligned.volume() ? turned : aligned;
  } catch (const InputError&) {
    return aligned;  // all vertices lie in a plane
  }
}

}  // namespace hydrabench

// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "baselines/template_cad/footprint.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

#include <Eigen/Geometry>

namespace hydrabench {
namespace {

using Eigen::Vector2d;

double cross(const Vector2d& a, const Vector2d& b) { return a.x() * b.y() - a.y() * b.x(); }

/// Second moments of a polygon's area about its centroid, by triangles from its first corner;
/// nullopt without area.
std::optional<Eigen::Matrix2d> areaMoments(const std::vector<Vector2d>& polygon) {
  double twice_area = 0;
  Vector2d first = Vector2d::Zero();                 // integral of the position
  Eigen::Matrix2d second = Eigen::Matrix2d::Zero();  // and of its outer product
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i) {
    const Vector2d a = polygon[i] - polygon[0];
    const Vector2d b = polygon[i + 1] - polygon[0];
    const double twice = cross(a, b);
    const Vector2d sum = a + b;
    twice_area += twice;
    first += twice / 6 * sum;
    second += twice / 24 * (sum * sum.transpose() + a * a.transpose() + b * b.transpose());
  }
  constexpr double kMinArea = 1e-6;  // [m^2]
  if (!(twice_area > 2 * kMinArea)) return std::nullopt;
  const double area = 0.5 * twice_area;
  return second - first * first.transpose() / area;
}

}  // namespace

std::vector<Vector2d> convexHull(std::span<const Eigen::Vector3d> points) {
  std::vector<Vector2d> sorted;
  sorted.reserve(points.size());
  for (const Eigen::Vector3d& point : points) sorted.emplace_back(point.x(), point.y());
  const auto before = [](const Vector2d& a, const Vector2d& b) {
    return a.x() != b.x() ? a.x() < b.x() : a.y() < b.y();
  };
  std::sort(sorted.begin(), sorted.end(), before);
  sorted.erase(std::unique(sorted.begin(), sorted.end()), sorted.end());
  if (sorted.size() < 3) return sorted;

  std::vector<Vector2d> hull;
  const auto extend = [&](const Vector2d& point, std::size_t start) {
    while (hull.size() >= start + 2 &&
           cross(hull.back() - hull[hull.size() - 2], point - hull.back()) <= 0) {
      hull.pop_back();
    }
    hull.push_back(point);
  };
  for (const Vector2d& point : sorted) extend(point, 0);
  hull.pop_back();  // the last of the lower chain is the first of the upper one
  const std::size_t upper = hull.size();
  for (auto point = sorted.rbegin(); point != sorted.rend(); ++point) extend(*point, upper);
  hull.pop_back();
  return hull;
}

std::optional<Footprint> footprintOf(std::span<const Eigen::Vector3d> points) {
  const std::vector<Vector2d> hull = convexHull(points);
  const std::optional<Eigen::Matrix2d> moments = areaMoments(hull);
  if (!moments) return std::nullopt;
  Footprint footprint;
  footprint.yaw = 0.5 * std::atan2(2 * (*moments)(0, 1), (*moments)(0, 0) - (*moments)(1, 1));
  if (footprint.yaw < 0) footprint.yaw += std::numbers::pi;
  if (footprint.yaw >= std::numbers::pi) footprint.yaw = 0;
  const Vector2d along(std::cos(footprint.yaw), std::sin(footprint.yaw));
  const Vector2d across(-along.y(), along.x());
  Eigen::AlignedBox2d extents;
  for (const Vector2d& corner : hull) {
    extents.extend(Vector2d(along.dot(corner), across.dot(corner)));
  }
  footprint.center = extents.center().x() * along + extents.center().y() * across;
  footprint.length = extents.sizes().x();
  footprint.width = extents.sizes().y();
  return footprint;
}

}  // namespace hydrabench

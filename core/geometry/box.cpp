// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "core/geometry/box.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace hydrabench {
namespace {

using Polygon = std::vector<Eigen::Vector3d>;

/// The part of a convex polygon where normal . x <= offset (Sutherland and Hodgman, CACM 1974).
Polygon clipped(const Polygon& polygon, const Eigen::Vector3d& normal, double offset) {
  Polygon kept;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Eigen::Vector3d& from = polygon[i];
    const Eigen::Vector3d& to = polygon[(i + 1) % polygon.size()];
    const double height_from = normal.dot(from) - offset;
    const double height_to = normal.dot(to) - offset;
    if (height_from <= 0) kept.push_back(from);
    if ((height_from < 0 && height_to > 0) || (height_from > 0 && height_to < 0)) {
      kept.emplace_back(from + (to - from) * (height_from / (height_from - height_to)));
    }
  }
  return kept;
}

double area(const Polygon& polygon, const Eigen::Vector3d& normal) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (std::size_t i = 2; i < polygon.size(); ++i) {
    sum += (polygon[i - 1] - polygon[0]).cross(polygon[i] - polygon[0]);
  }
  return 0.5 * std::abs(normal.dot(sum));
}

/// Adds sum(area * distance of the face's plane from the origin) over the faces of `box` cut by the
/// half-spaces of `cutter`. A face that lies in a face of the cutter with the same outward normal
/// belongs to both: it counts once, for `owns_shared`.
double faceIntegral(const OrientedBox& box, const OrientedBox& cutter, bool owns_shared,
                    double tolerance) {
  double integral = 0;
  for (int axis = 0; axis < 3; ++axis) {
    for (const double side : {-1.0, 1.0}) {
      const Eigen::Matrix3d axes = box.T_world_box.linear();
      const Eigen::Vector3d half = 0.5 * box.dimensions;
      const Eigen::Vector3d normal = side * axes.col(axis);
      const Eigen::Vector3d middle = box.T_world_box.translation() + half[axis] * normal;
      const int first = (axis + 1) % 3;
      const int second = (axis + 2) % 3;
      const Eigen::Vector3d u = half[first] * axes.col(first);
      const Eigen::Vector3d v = half[second] * axes.col(second);
      Polygon polygon = {middle - u - v, middle + u - v, middle + u + v, middle - u + v};

      for (int plane = 0; plane < 6 && !polygon.empty(); ++plane) {
        const int cutter_axis = plane / 2;
        const Eigen::Vector3d outward =
            (plane % 2 ? 1.0 : -1.0) * cutter.T_world_box.linear().col(cutter_axis);
        const double offset =
            outward.dot(cutter.T_world_box.translation()) + 0.5 * cutter.dimensions[cutter_axis];
        const auto liesInPlane = [&](const Eigen::Vector3d& p) {
          return std::abs(outward.dot(p) - offset) <= tolerance;
        };
        if (std::all_of(polygon.begin(), polygon.end(), liesInPlane)) {
          if (outward.dot(normal) < 0 || !owns_shared) polygon.clear();
        } else {
          polygon = clipped(polygon, outward, offset);
        }
      }
      integral += area(polygon, normal) * normal.dot(middle);
    }
  }
  return integral;
}

double iouOfVolumes(double intersection, double volume_a, double volume_b) {
  const double whole = volume_a + volume_b - intersection;
  return whole > 0 ? std::clamp(intersection / whole, 0.0, 1.0) : 0.0;
}

}  // namespace

double boxIou(const Aabb& a, const Aabb& b) {
  if (a.isEmpty() || b.isEmpty()) return 0;
  if (a.min() == b.min() && a.max() == b.max()) return 1;
  const Aabb both = a.intersection(b);
  return iouOfVolumes(both.isEmpty() ? 0.0 : both.volume(), a.volume(), b.volume());
}

double halfDiagonal(const Aabb& box) { return box.isEmpty() ? 0 : 0.5 * box.diagonal().norm(); }

double orientedBoxIou(const OrientedBox& a, const OrientedBox& b) {
  if (a.dimensions == b.dimensions && a.T_world_box.matrix() == b.T_world_box.matrix()) return 1;
  if (!(a.volume() > 0) || !(b.volume() > 0)) return 0;
  // In the frame of box a, so that the result keeps its digits far from the origin.
  OrientedBox a_local;
  a_local.dimensions = a.dimensions;
  OrientedBox b_local;
  b_local.T_world_box = a.T_world_box.inverse() * b.T_world_box;
  b_local.dimensions = b.dimensions;
  const double tolerance = 1e-12 * (a.dimensions.maxCoeff() + b.dimensions.maxCoeff());
  // Divergence theorem: volume = 1/3 sum over faces of area times distance of the plane from the
  // origin.
  const double intersection = (faceIntegral(a_local, b_local, true, tolerance) +
                               faceIntegral(b_local, a_local, false, tolerance)) /
                              3.0;
  return iouOfVolumes(std::max(0.0, intersection), a.volume(), b.volume());
}

}  // namespace hydrabench

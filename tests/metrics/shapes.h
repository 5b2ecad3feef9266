// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

#include "core/geometry/mesh.h"

namespace hydrabench {

inline Mesh cuboid(const Eigen::Vector3d& low, const Eigen::Vector3d& high) {
  return boxMesh(Aabb(low, high));
}

inline Mesh unitCube(double shift_x = 0) { return cuboid({shift_x, 0, 0}, {shift_x + 1, 1, 1}); }

inline Mesh moved(const Mesh& mesh, const Eigen::Vector3d& shift) {
  Mesh result = mesh;
  for (Eigen::Vector3d& vertex : result.vertices) vertex += shift;
  return result;
}

/// The mesh without the faces whose centre satisfies is_removed.
template <typename IsRemoved>
Mesh without(const Mesh& mesh, const IsRemoved& is_removed) {
  Mesh result = mesh;
  result.faces.clear();
  for (const Eigen::Vector3i& face : mesh.faces) {
    Eigen::Vector3d center = Eigen::Vector3d::Zero();
    for (const int i : face) center += mesh.vertices[static_cast<std::size_t>(i)] / 3;
    if (!is_removed(center)) result.faces.push_back(face);
  }
  return result;
}

inline Mesh openTopCube() {
  return without(unitCube(), [](const Eigen::Vector3d& center) { return center.z() > 0.999; });
}

/// A closed surface with bumps, without symmetry and not star-shaped: a bent, uneven ellipsoid.
inline Mesh potato(const Eigen::Vector3d& center, double radius, int subdivisions,
                   double phase = 0) {
  Mesh mesh = sphereMesh(Eigen::Vector3d::Zero(), 1, subdivisions);
  for (Eigen::Vector3d& v : mesh.vertices) {
    const double bump = 1 + 0.15 * std::sin(6 * v.x() + phase) * std::cos(5 * v.y());
    const Eigen::Vector3d stretched = bump * Eigen::Vector3d(v.x(), 0.7 * v.y(), 0.5 * v.z());
    v = center + radius * Eigen::Vector3d(stretched.x(), stretched.y(),
                                          stretched.z() + 0.4 * stretched.x() * stretched.x());
  }
  return mesh;
}

}  // namespace hydrabench

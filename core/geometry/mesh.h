// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "core/geometry/box.h"
#include "core/geometry/transform.h"
#include "core/types/color.h"

namespace hydrabench {

/// Indexed triangles; a soup is allowed, so real-world meshes survive unchanged. Counter-clockwise
/// seen from outside.
struct Mesh {
  std::vector<Eigen::Vector3d> vertices;  ///< [m]
  std::vector<Eigen::Vector3i> faces;     ///< indices into vertices
  std::vector<Rgb> colors;                ///< one per vertex, or empty

  bool empty() const { return faces.empty(); }
};

/// Box around all vertices. Empty for a mesh without vertices.
Aabb bounds(const Mesh& mesh);

/// Sum of the triangle areas [m^2].
double surfaceArea(const Mesh& mesh);

/// Signed volume by the divergence theorem [m^3]; meaningful for closed, consistently oriented
/// meshes.
double signedVolume(const Mesh& mesh);

Mesh transformed(const Transform& T_b_a, const Mesh& mesh_a);
Mesh scaled(double factor, Mesh mesh);
void append(const Mesh& part,
            Mesh& whole);  ///< colours are kept if both have them (or whole is empty)

/// Axis-aligned cuboid, 8 vertices, 12 faces, outward.
Mesh boxMesh(const Aabb& box);
/// Sphere by subdivision of an icosahedron; 20 * 4^subdivisions faces with vertices on the sphere.
Mesh sphereMesh(const Eigen::Vector3d& center, double radius, int subdivisions);

/// Vertices rounded to float, which is what mesh files store: what is written and read back is then
/// bit-equal.
void roundToFloat(Mesh& mesh);

}  // namespace hydrabench

// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "core/geometry/mesh.h"

#include <cmath>
#include <map>
#include <utility>

namespace hydrabench {
namespace {

Eigen::Vector3d corner(const Mesh& mesh, std::size_t face, int i) {
  return mesh.vertices[static_cast<std::size_t>(mesh.faces[face][i])];
}

}  // namespace

Aabb bounds(const Mesh& mesh) {
  Aabb box;
  for (const Eigen::Vector3d& vertex : mesh.vertices) box.extend(vertex);
  return box;
}

double surfaceArea(const Mesh& mesh) {
  double area = 0;
  for (std::size_t face = 0; face < mesh.faces.size(); ++face) {
    const Eigen::Vector3d a = corner(mesh, face, 0);
    area += 0.5 * (corner(mesh, face, 1) - a).cross(corner(mesh, face, 2) - a).norm();
  }
  return area;
}

double signedVolume(const Mesh& mesh) {
  if (mesh.faces.empty()) return 0;
  // Tetrahedra to a point of the mesh instead of the origin: far from the origin their volumes
  // would cancel.
  const Eigen::Vector3d apex = corner(mesh, 0, 0);
  double volume = 0;
  for (std::size_t face = 0; face < mesh.faces.size(); ++face) {
    const Eigen::Vector3d a = corner(mesh, face, 0) - apex;
    volume += a.dot((corner(mesh, face, 1) - apex).cross(corner(mesh, face, 2) - apex)) / 6.0;
  }
  return volume;
}

Mesh transformed(const Transform& T_b_a, const Mesh& mesh_a) {
  Mesh mesh_b = mesh_a;
  for (Eigen::Vector3d& vertex : mesh_b.vertices) vertex = T_b_a * vertex;
  return mesh_b;
}

Mesh scaled(double factor, Mesh mesh) {
  for (Eigen::Vector3d& vertex : mesh.vertices) vertex *= factor;
  return mesh;
}

void append(const Mesh& part, Mesh& whole) {
  const bool keeps_colors = whole.vertices.empty() || whole.colors.size() == whole.vertices.size();
  const Eigen::Vector3i offset = Eigen::Vector3i::Constant(static_cast<int>(whole.vertices.size()));
  if (keeps_colors && part.colors.size() == part.vertices.size()) {
    whole.colors.insert(whole.colors.end(), part.colors.begin(), part.colors.end());
  } else {
    whole.colors.clear();
  }
  whole.vertices.insert(whole.vertices.end(), part.vertices.begin(), part.vertices.end());
  whole.faces.reserve(whole.faces.size() + part.faces.size());
  for (const Eigen::Vector3i& face : part.faces) whole.faces.emplace_back(face + offset);
}

Mesh boxMesh(const Aabb& box) {
  Mesh mesh;
  for (int i = 0; i < 8; ++i) {
    mesh.vertices.emplace_back(i & 1 ? box.max().x() : box.min().x(),
                               i & 2 ? box.max().y() : box.min().y(),
                               i & 4 ? box.max().z() : box.min().z());
  }
  mesh.faces = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  return mesh;
}

Mesh sphereMesh(const Eigen::Vector3d& center, double radius, int subdivisions) {
  const double t = (1.0 + std::sqrt(5.0)) / 2.0;
  Mesh mesh;
  mesh.vertices = {{-1, t, 0},  {1, t, 0},  {-1, -t, 0}, {1, -t, 0}, {0, -1, t},  {0, 1, t},
                   {0, -1, -t}, {0, 1, -t}, {t, 0, -1},  {t, 0, 1},  {-t, 0, -1}, {-t, 0, 1}};
  mesh.faces = {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
                {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
                {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}};
  for (Eigen::Vector3d& vertex : mesh.vertices) vertex.normalize();
  for (int level = 0; level < subdivisions; ++level) {
    std::map<std::pair<int, int>, int> midpoints;
    const auto midpoint = [&](int a, int b) {
      const auto [entry, is_new] =
          midpoints.try_emplace(std::minmax(a, b), static_cast<int>(mesh.vertices.size()));
      if (is_new) {
        const Eigen::Vector3d sum =
            mesh.vertices[static_cast<std::size_t>(a)] + mesh.vertices[static_cast<std::size_t>(b)];
        mesh.vertices.push_back(sum.normalized());
      }
      return entry->second;
    };
    std::vector<Eigen::Vector3i> faces;
    faces.reserve(4 * mesh.faces.size());
    for (const Eigen::Vector3i& face : mesh.faces) {
      const Eigen::Vector3i middle(midpoint(face[0], face[1]), midpoint(face[1], face[2]),
                                   midpoint(face[2], face[0]));
      faces.emplace_back(face[0], middle[0], middle[2]);
      faces.emplace_back(face[1], middle[1], middle[0]);
      faces.emplace_back(face[2], middle[2], middle[1]);
      faces.push_back(middle);
    }
    mesh.faces = std::move(faces);
  }
  for (Eigen::Vector3d& vertex : mesh.vertices) vertex = center + radius * vertex;
  return mesh;
}

void roundToFloat(Mesh& mesh) {
  for (Eigen::Vector3d& vertex : mesh.vertices) {
    for (double& coordinate : vertex) {
      // volatile: GCC 12 drops the way to float and back where it vectorises straight-line code.
      const volatile float rounded = static_cast<float>(coordinate);
      coordinate = static_cast<double>(rounded);
    }
  }
}

}  // namespace hydrabench

// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/simulation/smooth_normals.h"

#include <cmath>
#include <cstddef>

#include <Eigen/Geometry>

namespace hydrabench {
namespace {

using Eigen::Vector3d;

}  // namespace

std::vector<Eigen::Vector3f> cornerNormals(const Mesh& mesh, double crease_rad) {
  const std::size_t num_faces = mesh.faces.size();
  std::vector<Vector3d> doubled_areas(num_faces);  // cross products
  std::vector<Vector3d> face_normals(num_faces);
  std::vector<std::size_t> first(mesh.vertices.size() + 1,
                                 0);  // faces of vertex v: first[v] ... first[v + 1]
  for (std::size_t f = 0; f < num_faces; ++f) {
    const Eigen::Vector3i& face = mesh.faces[f];
    const Vector3d& a = mesh.vertices[static_cast<std::size_t>(face[0])];
    const Vector3d& b = mesh.vertices[static_cast<std::size_t>(face[1])];
    const Vector3d& c = mesh.vertices[static_cast<std::size_t>(face[2])];
    doubled_areas[f] = (b - a).cross(c - a);
    face_normals[f] = doubled_areas[f].stableNormalized();
    for (int id : face) ++first[static_cast<std::size_t>(id) + 1];
  }
  for (std::size_t v = 1; v < first.size(); ++v) first[v] += first[v - 1];
  std::vector<std::size_t> faces_around(3 * num_faces);
  std::vector<std::size_t> next = first;
  for (std::size_t f = 0; f < num_faces; ++f) {
    for (int id : mesh.faces[f]) faces_around[next[static_cast<std::size_t>(id)]++] = f;
  }

  const double least_cosine = std::cos(crease_rad);
  std::vector<Eigen::Vector3f> normals(3 * num_faces);
  for (std::size_t f = 0; f < num_faces; ++f) {
    for (int k = 0; k < 3; ++k) {
      const auto vertex = static_cast<std::size_t>(mesh.faces[f][k]);
      Vector3d sum = Vector3d::Zero();
      for (std::size_t i = first[vertex]; i < first[vertex + 1]; ++i) {
        const std::size_t other = faces_around[i];
        if (face_normals[other].dot(face_normals[f]) >= least_cosine) sum += doubled_areas[other];
      }
      if (!(sum.squaredNorm() > 0)) sum = face_normals[f];
      normals[3 * f + static_cast<std::size_t>(k)] = sum.stableNormalized().cast<float>();
    }
  }
  return normals;
}

}  // namespace hydrabench

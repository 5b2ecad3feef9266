// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

#include "eval/simulation/shape_family.h"
#include "eval/simulation/surface_mesher.h"
#include "eval/simulation/surface_simplifier.h"

namespace hydrabench {
namespace {

int rootOf(std::vector<int>& parent, int i) {
  while (parent[static_cast<std::size_t>(i)] != i) {
    int& up = parent[static_cast<std::size_t>(i)];
    up = parent[static_cast<std::size_t>(up)];
    i = up;
  }
  return i;
}

/// The piece with the most faces. Others are voids enclosed between parts (under a couch's
/// cushions), which nobody can see or touch, and crumbs where a part is thinner than the grid.
SurfaceMesh largestPiece(SurfaceMesh surface) {
  std::vector<int> parent(surface.mesh.vertices.size());
  std::iota(parent.begin(), parent.end(), 0);
  for (const Eigen::Vector3i& face : surface.mesh.faces) {
    for (int k = 1; k < 3; ++k) {
      parent[static_cast<std::size_t>(rootOf(parent, face[k]))] = rootOf(parent, face[0]);
    }
  }
  std::vector<std::size_t> faces_of_root(parent.size(), 0);
  for (const Eigen::Vector3i& face : surface.mesh.faces) {
    ++faces_of_root[static_cast<std::size_t>(rootOf(parent, face[0]))];
  }
  const auto largest = static_cast<int>(
      std::max_element(faces_of_root.begin(), faces_of_root.end()) - faces_of_root.begin());
  if (faces_of_root[static_cast<std::size_t>(largest)] == surface.mesh.faces.size()) return surface;

  SurfaceMesh piece;
  std::vector<int> new_id(parent.size(), -1);
  for (std::size_t f = 0; f < surface.mesh.faces.size(); ++f) {
    Eigen::Vector3i face = surface.mesh.faces[f];
    if (rootOf(parent, face[0]) != largest) continue;
    for (int& id : face) {
      int& renumbered = new_id[static_cast<std::size_t>(id)];
      if (renumbered < 0) {
        renumbered = static_cast<int>(piece.mesh.vertices.size());
        piece.mesh.vertices.push_back(surface.mesh.vertices[static_cast<std::size_t>(id)]);
      }
      id = renumbered;
    }
    piece.mesh.faces.push_back(face);
    piece.face_part.push_back(surface.face_part[f]);
  }
  return piece;
}

}  // namespace

SurfaceMesh meshInstance(const ShapeInstance& instance) {
  constexpr double kMaxError = 2e-4;  // [m]
  constexpr std::size_t kMaxFaces = 12000;
  // Two samples or more across the thinnest part.
  const double pitch = std::clamp(0.45 * instance.thinnest_m, 0.0035, instance.max_pitch_m);
  SurfaceMesh surface =
      simplifySurface(largestPiece(extractSurface(instance.parts, pitch)), kMaxError, kMaxFaces);
  roundToFloat(surface.mesh);
  return surface;
}

}  // namespace hydrabench

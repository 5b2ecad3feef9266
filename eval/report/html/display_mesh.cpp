// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/report/html/display_mesh.h"

#include <algorithm>
#include <limits>
#include <map>
#include <meshoptimizer.h>
#include <utility>
#include <vector>

#include "core/geometry/mesh_topology.h"

namespace hydrabench {
namespace {

constexpr double kLongestEdge = 0.1;  // of the diagonal
constexpr int kRounds = 3;            // of halving

/// Halves every edge longer than `longest`. Whether an edge is halved depends on it alone, so no
/// gap opens between neighbours.
Mesh halved(const Mesh& mesh, double longest) {
  Mesh result = mesh;
  result.faces.clear();
  std::map<std::pair<int, int>, int> middles;
  const auto middle = [&](int a, int b) {
    const auto& from = mesh.vertices[static_cast<std::size_t>(a)];
    const auto& to = mesh.vertices[static_cast<std::size_t>(b)];
    if ((to - from).norm() <= longest) return -1;
    const auto [place, is_new] =
        middles.emplace(std::minmax(a, b), static_cast<int>(result.vertices.size()));
    if (is_new) {
      result.vertices.push_back((from + to) / 2);
      if (!mesh.colors.empty()) result.colors.push_back(mesh.colors[static_cast<std::size_t>(a)]);
    }
    return place->second;
  };
  for (const Eigen::Vector3i& face : mesh.faces) {
    // Around the face, the middles where they are: cut off a corner between two of them, fan the
    // rest.
    std::vector<int> ring;
    for (int k = 0; k < 3; ++k) {
      ring.push_back(face[k]);
      const int m = middle(face[k], face[(k + 1) % 3]);
      if (m >= 0) ring.push_back(m);
    }
    if (ring.size() == 6) {
      result.faces.insert(result.faces.end(), {{ring[0], ring[1], ring[5]},
                                               {ring[2], ring[3], ring[1]},
                                               {ring[4], ring[5], ring[3]},
                                               {ring[1], ring[3], ring[5]}});
      continue;
    }
    // From a middle, so that no part has all its corners on one edge.
    std::size_t start = 0;
    while (start < ring.size() && ring.size() > 3 &&
           ring[start] < static_cast<int>(mesh.vertices.size())) {
      ++start;
    }
    for (std::size_t k = 1; k + 1 < ring.size(); ++k) {
      result.faces.emplace_back(ring[start % ring.size()], ring[(start + k) % ring.size()],
                                ring[(start + k + 1) % ring.size()]);
    }
  }
  return result;
}

}  // namespace

Mesh coarseMesh(const Mesh& mesh, std::size_t faces) {
  constexpr float kAnyError = std::numeric_limits<float>::max();
  const Mesh input = welded(mesh);
  if (input.faces.size() <= faces) return input;
  std::vector<float> positions;
  for (const Eigen::Vector3d& vertex : input.vertices) {
    for (int k = 0; k < 3; ++k) positions.push_back(static_cast<float>(vertex[k]));
  }
  std::vector<unsigned int> corners;
  for (const Eigen::Vector3i& face : input.faces) {
    for (int k = 0; k < 3; ++k) corners.push_back(static_cast<unsigned int>(face[k]));
  }
  std::vector<unsigned int> left(corners.size());
  left.resize(meshopt_simplify(left.data(), corners.data(), corners.size(), positions.data(),
                               input.vertices.size(), 3 * sizeof(float), 3 * faces, kAnyError, 0,
                               nullptr));
  // Faces beside each other in space stand beside each other in the list: it compresses better.
  meshopt_optimizeVertexCache(left.data(), left.data(), left.size(), input.vertices.size());
  Mesh result;
  result.vertices = input.vertices;
  result.colors = input.colors;
  for (std::size_t i = 0; i < left.size(); i += 3) {
    result.faces.emplace_back(static_cast<int>(left[i]), static_cast<int>(left[i + 1]),
                              static_cast<int>(left[i + 2]));
  }
  return welded(result);
}

Mesh displayMesh(const Mesh& mesh, std::size_t faces) {
  Mesh result = coarseMesh(mesh, faces);
  const double longest = kLongestEdge * bounds(result).diagonal().norm();
  for (int round = 0; round < kRounds && !result.empty(); ++round) {
    const std::size_t before = result.faces.size();
    result = halved(result, longest);
    if (result.faces.size() == before) break;
  }
  return result;
}

}  // namespace hydrabench

// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/report/html/shape_set.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string_view>

#include "core/geometry/raycaster.h"
#include "core/parallel/parallel_for.h"
#include "eval/report/html/display_mesh.h"

namespace hydrabench {
namespace {

std::size_t hashOf(const Mesh& mesh) {
  const std::string_view bytes(reinterpret_cast<const char*>(mesh.vertices.data()),
                               mesh.vertices.size() * sizeof(Eigen::Vector3d));
  return std::hash<std::string_view>()(bytes);
}

bool equal(const Mesh& a, const Mesh& b) {
  return a.vertices == b.vertices && a.faces == b.faces && a.colors == b.colors;
}

Raycaster surfaceOf(const Mesh& mesh) {
  Raycaster surface;
  surface.add(mesh);
  surface.commit();
  return surface;
}

std::string distances(const PackedMesh& packed, const Raycaster& surface) {
  std::string bytes;
  for (const Eigen::Vector3d& vertex : unpackMesh(packed).vertices) {
    const double millimetres = 1000 * surface.nearest(vertex).distance;
    bytes += static_cast<char>(static_cast<std::uint8_t>(std::min(255.0, std::round(millimetres))));
  }
  return bytes;
}

}  // namespace

std::size_t ShapeSet::add(const Mesh& mesh) {
  const std::size_t hash = hashOf(mesh);
  const auto [begin, end] = by_hash_.equal_range(hash);
  for (auto known = begin; known != end; ++known) {
    if (equal(*meshes_[known->second], mesh)) return known->second;
  }
  by_hash_.emplace(hash, meshes_.size());
  meshes_.push_back(&mesh);
  return meshes_.size() - 1;
}

std::vector<PackedMesh> packShapes(const ShapeSet& shapes, std::size_t faces) {
  std::vector<PackedMesh> packed(shapes.size());
  parallelFor(shapes.size(),
              [&](std::size_t i) { packed[i] = packMesh(displayMesh(shapes.mesh(i), faces)); });
  return packed;
}

std::vector<PairDistances> pairDistances(const ShapeSet& shapes,
                                         const std::vector<PackedMesh>& packed,
                                         const std::vector<ShapePair>& pairs) {
  // By truth, so that its surface is prepared once; an estimate is seldom in two pairs.
  std::map<std::size_t, std::vector<std::size_t>> of_truth;
  for (std::size_t i = 0; i < pairs.size(); ++i) of_truth[pairs[i].truth].push_back(i);
  const std::vector<std::pair<std::size_t, std::vector<std::size_t>>> groups(of_truth.begin(),
                                                                             of_truth.end());
  std::vector<PairDistances> result(pairs.size());
  parallelFor(groups.size(), [&](std::size_t g) {
    const auto& [truth, members] = groups[g];
    const Raycaster true_surface = surfaceOf(shapes.mesh(truth));
    for (const std::size_t i : members) {
      const std::size_t estimate = pairs[i].estimate;
      result[i].on_estimate = distances(packed[estimate], true_surface);
      result[i].on_truth = distances(packed[truth], surfaceOf(shapes.mesh(estimate)));
    }
  });
  return result;
}

}  // namespace hydrabench

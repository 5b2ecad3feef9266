// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "core/geometry/mesh_topology.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <numeric>
#include <tuple>

namespace hydrabench {
namespace {

/// Of every vertex the first one at exactly the same position.
std::vector<int> firstAtSamePosition(const Mesh& mesh) {
  const auto position = [&](int i) {
    const Eigen::Vector3d& v = mesh.vertices[static_cast<std::size_t>(i)];
    return std::tuple(v.x(), v.y(), v.z());
  };
  std::vector<int> order(mesh.vertices.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), [&](int a, int b) {
    return std::tuple_cat(position(a), std::tuple(a)) < std::tuple_cat(position(b), std::tuple(b));
  });
  std::vector<int> first(mesh.vertices.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    const auto vertex = static_cast<std::size_t>(order[i]);
    const bool repeats = i > 0 && position(order[i]) == position(order[i - 1]);
    first[vertex] = repeats ? first[static_cast<std::size_t>(order[i - 1])] : order[i];
  }
  return first;
}

Eigen::Vector3i mapped(const Eigen::Vector3i& face, const std::vector<int>& map) {
  return face.unaryExpr([&](int i) { return map[static_cast<std::size_t>(i)]; });
}

bool isDegenerate(const Eigen::Vector3i& face) {
  return face[0] == face[1] || face[1] == face[2] || face[2] == face[0];
}

/// Disjoint sets over 0 .. count - 1; the smallest member represents its set.
class DisjointSets {
 public:
  explicit DisjointSets(std::size_t count) : parent_(count) {
    std::iota(parent_.begin(), parent_.end(), std::size_t{0});
  }
  std::size_t find(std::size_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  void join(std::size_t a, std::size_t b) {
    a = find(a);
    b = find(b);
    parent_[std::max(a, b)] = std::min(a, b);
  }

 private:
  std::vector<std::size_t> parent_;
};

struct HalfEdge {
  int low = 0;   ///< smaller vertex
  int high = 0;  ///< larger vertex
  bool forward = false;
  std::size_t face = 0;
  auto key() const { return std::pair(low, high); }
};

/// The part of `mesh` made of these faces, vertices in their first order.
Mesh subMesh(const Mesh& mesh, const std::vector<std::size_t>& faces) {
  std::vector<int> used;
  used.reserve(3 * faces.size());
  for (const std::size_t face : faces) {
    used.insert(used.end(), mesh.faces[face].begin(), mesh.faces[face].end());
  }
  std::sort(used.begin(), used.end());
  used.erase(std::unique(used.begin(), used.end()), used.end());

  Mesh part;
  const bool has_colors = mesh.colors.size() == mesh.vertices.size();
  part.vertices.reserve(used.size());
  for (const int vertex : used) {
    part.vertices.push_back(mesh.vertices[static_cast<std::size_t>(vertex)]);
    if (has_colors) part.colors.push_back(mesh.colors[static_cast<std::size_t>(vertex)]);
  }
  part.faces.reserve(faces.size());
  for (const std::size_t face : faces) {
    part.faces.emplace_back(mesh.faces[face].unaryExpr([&](int vertex) {
      return static_cast<int>(std::lower_bound(used.begin(), used.end(), vertex) - used.begin());
    }));
  }
  return part;
}

}  // namespace

MeshTopology analyzeTopology(const Mesh& mesh) {
  const std::vector<int> first = firstAtSamePosition(mesh);
  std::vector<HalfEdge> edges;
  edges.reserve(3 * mesh.faces.size());
  for (std::size_t i = 0; i < mesh.faces.size(); ++i) {
    const Eigen::Vector3i face = mapped(mesh.faces[i], first);
    if (isDegenerate(face)) continue;
    for (int k = 0; k < 3; ++k) {
      const int from = face[k];
      const int to = face[(k + 1) % 3];
      edges.push_back({std::min(from, to), std::max(from, to), from < to, i});
    }
  }
  std::sort(edges.begin(), edges.end(), [](const HalfEdge& a, const HalfEdge& b) {
    return std::tuple(a.low, a.high, a.face) < std::tuple(b.low, b.high, b.face);
  });

  MeshTopology topology;
  DisjointSets sets(mesh.faces.size());
  for (std::size_t begin = 0, end = 0; begin < edges.size(); begin = end) {
    while (end < edges.size() && edges[end].key() == edges[begin].key()) ++end;
    for (std::size_t i = begin + 1; i < end; ++i) sets.join(edges[begin].face, edges[i].face);
    const std::size_t num_faces = end - begin;
    if (num_faces == 1) {
      ++topology.boundary_edges;
      topology.boundary_length += (mesh.vertices[static_cast<std::size_t>(edges[begin].high)] -
                                   mesh.vertices[static_cast<std::size_t>(edges[begin].low)])
                                      .norm();
    } else if (num_faces == 2) {
      if (edges[begin].forward == edges[begin + 1].forward) ++topology.misoriented_edges;
    } else {
      ++topology.nonmanifold_edges;
    }
  }
  for (std::size_t i = 0; i < mesh.faces.size(); ++i) {
    if (!isDegenerate(mapped(mesh.faces[i], first)) && sets.find(i) == i) ++topology.components;
  }
  return topology;
}

Mesh welded(const Mesh& mesh) {
  const std::vector<int> first = firstAtSamePosition(mesh);
  Mesh merged;
  merged.vertices = mesh.vertices;
  merged.colors = mesh.colors;
  merged.faces.reserve(mesh.faces.size());
  for (const Eigen::Vector3i& face : mesh.faces) {
    const Eigen::Vector3i corners = mapped(face, first);
    if (!isDegenerate(corners)) merged.faces.push_back(corners);
  }
  std::vector<std::size_t> all(merged.faces.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  return subMesh(merged, all);
}

std::vector<Mesh> connectedComponents(const Mesh& mesh) {
  const std::vector<int> first = firstAtSamePosition(mesh);
  DisjointSets sets(mesh.vertices.size());
  for (const Eigen::Vector3i& face : mesh.faces) {
    const Eigen::Vector3i corners = mapped(face, first);
    sets.join(static_cast<std::size_t>(corners[0]), static_cast<std::size_t>(corners[1]));
    sets.join(static_cast<std::size_t>(corners[0]), static_cast<std::size_t>(corners[2]));
  }
  std::vector<std::vector<std::size_t>> faces_of_set(mesh.vertices.size());
  for (std::size_t i = 0; i < mesh.faces.size(); ++i) {
    const auto vertex = static_cast<std::size_t>(mapped(mesh.faces[i], first)[0]);
    faces_of_set[sets.find(vertex)].push_back(i);
  }
  std::vector<Mesh> components;
  for (const std::vector<std::size_t>& faces : faces_of_set) {
    if (!faces.empty()) components.push_back(subMesh(mesh, faces));
  }
  std::vector<double> areas;
  for (const Mesh& component : components) areas.push_back(surfaceArea(component));
  std::vector<std::size_t> order(components.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return areas[a] > areas[b]; });
  std::vector<Mesh> sorted;
  for (const std::size_t i : order) sorted.push_back(std::move(components[i]));
  return sorted;
}

}  // namespace hydrabench

// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "core/geometry/mesh_topology.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <numeric>
#include <tuple>
#include <utility>

namespace hydrabench {
namespace {

/// Of every vertex the first one at exactly the same position.
std::vector<int> firstAtSamePosition(const Mesh& mesh) {
  struct Place {
    double x, y, z;
    int vertex;
  };
  std::vector<Place> places;
  places.reserve(mesh.vertices.size());
  for (const Eigen::Vector3d& v : mesh.vertices) {
    places.push_back({v.x(), v.y(), v.z(), static_cast<int>(places.size())});
  }
  std::sort(places.begin(), places.end(), [](const Place& a, const Place& b) {
    return std::tie(a.x, a.y, a.z, a.vertex) < std::tie(b.x, b.y, b.z, b.vertex);
  });
  std::vector<int> first(mesh.vertices.size());
  int current = 0;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const Place& place = places[i];
    const bool repeats = i > 0 && place.x == places[i - 1].x && place.y == places[i - 1].y &&
                         place.z == places[i - 1].z;
    if (!repeats) current = place.vertex;
    first[static_cast<std::size_t>(place.vertex)] = current;
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

/// Takes parts out of a mesh.
class PartCutter {
 public:
  explicit PartCutter(const Mesh& mesh) : mesh_(mesh), place_(mesh.vertices.size(), kUnused) {}

  /// The part made of these faces, vertices in their first order.
  Mesh part(const std::vector<std::size_t>& faces) {
    std::vector<int> used;
    for (const std::size_t face : faces) {
      for (const int vertex : mesh_.faces[face]) {
        if (std::exchange(place_[static_cast<std::size_t>(vertex)], 0) == kUnused) {
          used.push_back(vertex);
        }
      }
    }
    std::sort(used.begin(), used.end());

    Mesh part;
    const bool has_colors = mesh_.colors.size() == mesh_.vertices.size();
    part.vertices.reserve(used.size());
    for (const int used_vertex : used) {
      const auto vertex = static_cast<std::size_t>(used_vertex);
      place_[vertex] = static_cast<int>(part.vertices.size());
      part.vertices.push_back(mesh_.vertices[vertex]);
      if (has_colors) part.colors.push_back(mesh_.colors[vertex]);
    }
    part.faces.reserve(faces.size());
    for (const std::size_t face : faces) part.faces.push_back(mapped(mesh_.faces[face], place_));
    for (const int vertex : used) place_[static_cast<std::size_t>(vertex)] = kUnused;
    return part;
  }

 private:
  static constexpr int kUnused = -1;
  const Mesh& mesh_;
  std::vector<int> place_;  ///< of each vertex in the part at hand; all kUnused between parts
};

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
  return PartCutter(merged).part(all);
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
  PartCutter cutter(mesh);
  for (const std::vector<std::size_t>& faces : faces_of_set) {
    if (!faces.empty()) components.push_back(cutter.part(faces));
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

// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "baselines/hydra/mesh_objects.h"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <utility>

#include "baselines/hydra/mesh_clustering.h"

namespace hydrabench {
namespace {

using Node = MeshObjects::Node;

std::vector<VertexId> unite(const std::vector<VertexId>& a, const std::vector<VertexId>& b) {
  std::vector<VertexId> all;
  all.reserve(a.size() + b.size());
  std::set_union(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(all));
  return all;
}

struct Extent {
  Aabb box;
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
};

Extent extentOf(const MapMesh& mesh, const std::vector<VertexId>& vertices) {
  Extent extent;
  if (vertices.empty()) return extent;
  for (const VertexId id : vertices) {
    extent.box.extend(mesh.position(id));
    extent.mean += mesh.position(id);
  }
  extent.mean /= static_cast<double>(vertices.size());
  // Rounding must not move the mean of a flat set out of its box.
  extent.mean = extent.mean.cwiseMax(extent.box.min()).cwiseMin(extent.box.max());
  return extent;
}

/// Lets go of vertices that died or changed their class, and looks at the others anew.
void refreshNode(const MapMesh& mesh, Node& node) {
  std::erase_if(node.vertices,
                [&](VertexId id) { return !mesh.alive(id) || mesh.label(id) != node.label; });
  node.active = std::any_of(node.vertices.begin(), node.vertices.end(),
                            [&](VertexId id) { return mesh.active(id); });
  const Extent extent = extentOf(mesh, node.vertices);
  node.box = extent.box;
  node.position = extent.mean;
}

/// Whether all that is left of the vertices is frozen. A node whose vertices all died has lost its
/// surface or is measured anew, but has not left the window.
bool archived(const MapMesh& mesh, const Node& node) {
  bool frozen = false;
  for (const VertexId id : node.vertices) {
    if (mesh.active(id)) return false;
    frozen = frozen || mesh.alive(id);
  }
  return frozen;
}

void absorb(const MapMesh& mesh, const Node& other, Node& node) {
  node.vertices = unite(node.vertices, other.vertices);
  node.first_observed_ns = std::min(node.first_observed_ns, other.first_observed_ns);
  node.last_observed_ns = std::max(node.last_observed_ns, other.last_observed_ns);
  refreshNode(mesh, node);
}

bool oneContainsTheOther(const Node& a, const Node& b) {
  return a.box.contains(b.position) || b.box.contains(a.position);
}

}  // namespace

MeshObjects::MeshObjects(const Config& config, std::vector<Label> labels)
    : config_(config), labels_(std::move(labels)) {
  std::sort(labels_.begin(), labels_.end());
}

void MeshObjects::update(const MapMesh& mesh, std::int64_t stamp_ns) {
  for (Node& node : nodes_) node.active = node.active && !archived(mesh, node);
  for (auto& [label, clusters_of_label] : clusters(mesh)) {
    for (std::vector<VertexId>& cluster : clusters_of_label) {
      associate(mesh, label, std::move(cluster), stamp_ns);
    }
  }
  mergeActive(mesh);
  refresh(mesh);
  if (config_.merge_revisited) mergeRevisited(mesh);
}

void MeshObjects::refresh(const MapMesh& mesh) {
  for (Node& node : nodes_) {
    if (node.active) refreshNode(mesh, node);
  }
  std::erase_if(nodes_, [this](const Node& node) {
    return node.vertices.size() < static_cast<std::size_t>(config_.min_cluster_size);
  });
}

std::map<Label, MeshObjects::Clusters> MeshObjects::clusters(const MapMesh& mesh) const {
  std::map<Label, std::vector<VertexId>> vertices;
  for (const VertexId id : mesh.activeVertices()) {
    const Label label = mesh.label(id);
    if (std::binary_search(labels_.begin(), labels_.end(), label)) vertices[label].push_back(id);
  }
  std::map<Label, Clusters> clusters;
  for (const auto& [label, ids] : vertices) {
    std::vector<Eigen::Vector3d> points;
    points.reserve(ids.size());
    for (const VertexId id : ids) points.push_back(mesh.position(id));
    for (const auto& members : euclideanClusters(points, config_.cluster_tolerance_m)) {
      if (members.size() < static_cast<std::size_t>(config_.min_cluster_size)) continue;
      if (members.size() > static_cast<std::size_t>(config_.max_cluster_size)) continue;
      std::vector<VertexId>& cluster = clusters[label].emplace_back();
      for (const std::uint32_t i : members) cluster.push_back(ids[i]);
    }
  }
  return clusters;
}

void MeshObjects::associate(const MapMesh& mesh, Label label, std::vector<VertexId> cluster,
                            std::int64_t stamp_ns) {
  const Eigen::Vector3d centroid = extentOf(mesh, cluster).mean;
  const auto match = std::find_if(nodes_.begin(), nodes_.end(), [&](const Node& node) {
    return node.active && node.label == label && node.box.contains(centroid);
  });
  if (match == nodes_.end()) {
    Node node;
    node.number = next_number_++;
    node.label = label;
    node.vertices = std::move(cluster);
    node.first_observed_ns = node.last_observed_ns = stamp_ns;
    refreshNode(mesh, node);
    nodes_.push_back(std::move(node));
    return;
  }
  std::vector<VertexId> all = unite(match->vertices, cluster);
  if (all.size() > match->vertices.size()) match->last_observed_ns = stamp_ns;
  match->vertices = std::move(all);
  refreshNode(mesh, *match);
}

void MeshObjects::mergeActive(const MapMesh& mesh) {
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    for (std::size_t j = i + 1; j < nodes_.size();) {
      const bool merge = nodes_[i].active && nodes_[j].active &&
                         nodes_[i].label == nodes_[j].label &&
                         oneContainsTheOther(nodes_[i], nodes_[j]);
      if (!merge) {
        ++j;
        continue;
      }
      absorb(mesh, nodes_[j], nodes_[i]);
      nodes_.erase(nodes_.begin() + static_cast<std::ptrdiff_t>(j));
      j = i + 1;  // it has grown: look at all again
    }
  }
}

void MeshObjects::mergeRevisited(const MapMesh& mesh) {
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    if (!nodes_[i].active) continue;
    std::size_t nearest = nodes_.size();
    const auto distance = [&](std::size_t j) {
      return (nodes_[j].position - nodes_[i].position).squaredNorm();
    };
    for (std::size_t j = 0; j < nodes_.size(); ++j) {
      if (nodes_[j].active || nodes_[j].label != nodes_[i].label) continue;
      if (nearest == nodes_.size() || distance(j) < distance(nearest)) nearest = j;
    }
    if (nearest == nodes_.size() || !oneContainsTheOther(nodes_[i], nodes_[nearest])) continue;
    // The older one stays; it is active from here on.
    const std::size_t older = std::min(i, nearest);
    const std::size_t newer = std::max(i, nearest);
    absorb(mesh, nodes_[newer], nodes_[older]);
    nodes_.erase(nodes_.begin() + static_cast<std::ptrdiff_t>(newer));
    if (newer == i) --i;
  }
}

void read(ConfigReader& reader, MeshObjects::Config& config) {
  reader.field("cluster_tolerance_m", config.cluster_tolerance_m, Bounds{1e-6, 1e3});
  reader.field("min_cluster_size", config.min_cluster_size, Bounds{1, 1e9});
  reader.field("max_cluster_size", config.max_cluster_size, Bounds{1, 1e9});
  reader.field("merge_revisited", config.merge_revisited);
}

}  // namespace hydrabench

// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "core/mapping/map_mesh.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

namespace hydrabench {
namespace {

using Triple = std::array<std::uint32_t, 3>;

/// Leaves one face of each three corners, the first; none where as many face one way as the other.
void removeDuplicates(std::vector<Triple>& faces) {
  struct Key {
    Triple corners;      // ascending
    std::uint32_t face;  // index
    int turn;            // 1 or -1: an even or odd permutation of `corners`
  };
  std::vector<Key> keys;
  keys.reserve(faces.size());
  for (std::size_t i = 0; i < faces.size(); ++i) {
    Key key{faces[i], static_cast<std::uint32_t>(i), 1};
    const auto order = [&key](std::size_t a, std::size_t b) {
      if (key.corners[a] <= key.corners[b]) return;
      std::swap(key.corners[a], key.corners[b]);
      key.turn = -key.turn;
    };
    order(0, 1);
    order(1, 2);
    order(0, 1);
    keys.push_back(key);
  }
  std::sort(keys.begin(), keys.end(), [](const Key& a, const Key& b) {
    return a.corners != b.corners ? a.corners < b.corners : a.face < b.face;
  });
  std::vector<char> keep(faces.size(), 0);
  for (std::size_t begin = 0, end = 0; begin < keys.size(); begin = end) {
    int turns = 0;
    for (; end < keys.size() && keys[end].corners == keys[begin].corners; ++end) {
      turns += keys[end].turn;
    }
    for (std::size_t i = begin; i < end && turns != 0; ++i) {
      if ((keys[i].turn > 0) != (turns > 0)) continue;
      keep[keys[i].face] = 1;
      break;
    }
  }
  std::size_t kept = 0;
  for (std::size_t i = 0; i < faces.size(); ++i) {
    if (keep[i]) faces[kept++] = faces[i];
  }
  faces.resize(kept);
}

}  // namespace

MapMesh::MapMesh(double merge_resolution_m, Revisited revisited)
    : merge_resolution_m_(merge_resolution_m), revisited_(revisited) {
  assert(merge_resolution_m > 0);
}

void MapMesh::update(const BlockIndex& block, const TriangleSoup& triangles) {
  auto place = blocks_.find(block);
  if (place == blocks_.end()) {
    if (triangles.vertices.empty()) return;
    place = blocks_.emplace(block, Block()).first;
  }
  const std::vector<Slot> before = std::move(place->second.vertices);
  Block& now = place->second;
  now.vertices.clear();
  now.faces.clear();
  now.faces.reserve(triangles.vertices.size() / 3);

  ++visit_;
  Face face;
  for (std::size_t i = 0; i < triangles.vertices.size(); ++i) {
    const Slot slot = slotInCellOf(triangles.vertices[i]);
    Vertex& vertex = vertices_[slot];
    if (vertex.last_visit != visit_) {
      vertex.last_visit = visit_;
      vertex.position = triangles.vertices[i];
      vertex.color = triangles.colors[i];
      vertex.label = triangles.labels[i];
      ++vertex.users;
      now.vertices.push_back(slot);
    }
    face[i % 3] = slot;
    if (i % 3 != 2) continue;
    if (face[0] != face[1] && face[1] != face[2] && face[2] != face[0]) now.faces.push_back(face);
  }
  // Only now, so that vertices which stay are never without a user.
  for (Slot slot : before) dropUser(slot);
  if (now.vertices.empty()) blocks_.erase(place);

  if (recent_ids_.size() > 1024 && recent_ids_.size() > 2 * cells_.size()) {
    std::erase_if(recent_ids_, [this](VertexId id) { return !active(id); });
  }
}

void MapMesh::archive(const BlockIndex& block, double confidence, bool left) {
  const auto known = versions_.find(block);
  const bool again = known != versions_.end() && known->second.complete;
  if (known != versions_.end() && left) known->second.complete = true;
  const auto place = blocks_.find(block);
  if (place == blocks_.end()) return;
  FrozenBlock frozen;
  if (again && confidence <= known->second.confidence) place->second.faces.clear();
  frozen.faces = std::move(place->second.faces);
  frozen.faces.shrink_to_fit();
  for (const Face& face : frozen.faces) {
    for (Slot slot : face) {
      vertices_[slot].in_frozen_face = true;
      frozen.box.extend(vertices_[slot].position);
    }
  }
  for (Slot slot : place->second.vertices) dropUser(slot);
  blocks_.erase(place);
  if (frozen.faces.empty()) return;
  if (known != versions_.end()) {
    FrozenBlock& version = frozen_[known->second.frozen];
    if (!again) {  // more of the same visit
      frozen.faces.insert(frozen.faces.end(), version.faces.begin(), version.faces.end());
      frozen.box.extend(version.box);
    }
    version = std::move(frozen);
    known->second.confidence = confidence;
    known->second.complete = left;
    return;
  }
  if (revisited_ == Revisited::kBest) {
    versions_.emplace(block, Version{frozen_.size(), confidence, left});
  }
  frozen_.push_back(std::move(frozen));
}

const MapMesh::Vertex& MapMesh::vertex(VertexId id) const {
  assert(alive(id));
  return vertices_[slot_of_id_[id]];
}

Eigen::Vector3i MapMesh::cellOf(const Eigen::Vector3d& position) const {
  return floored((position / merge_resolution_m_).array() + 0.5);
}

MapMesh::Slot MapMesh::slotInCellOf(const Eigen::Vector3d& position) {
  Slot& slot = cells_.findOrAdd(cellOf(position));
  if (slot != kNoSlot) return slot;
  if (free_slots_.empty()) {
    slot = static_cast<Slot>(vertices_.size());
    vertices_.emplace_back();
  } else {
    slot = free_slots_.back();
    free_slots_.pop_back();
    vertices_[slot] = {};
  }
  vertices_[slot].id = static_cast<VertexId>(slot_of_id_.size());
  recent_ids_.push_back(vertices_[slot].id);
  slot_of_id_.push_back(slot);
  return slot;
}

void MapMesh::dropUser(Slot slot) {
  Vertex& vertex = vertices_[slot];
  if (--vertex.users > 0) return;
  cells_.erase(cellOf(vertex.position));
  if (vertex.in_frozen_face) return;
  slot_of_id_[vertex.id] = kNoSlot;
  free_slots_.push_back(slot);
}

std::vector<VertexId> MapMesh::activeVertices() const {
  std::vector<VertexId> ids;
  ids.reserve(cells_.size());
  std::copy_if(recent_ids_.begin(), recent_ids_.end(), std::back_inserter(ids),
               [this](VertexId id) { return active(id); });
  return ids;
}

Mesh MapMesh::mesh(std::vector<Label>* labels) const {
  std::vector<Face> faces;
  for (const FrozenBlock& block : frozen_) {
    faces.insert(faces.end(), block.faces.begin(), block.faces.end());
  }
  for (const auto& [index, block] : blocks_) {
    faces.insert(faces.end(), block.faces.begin(), block.faces.end());
  }
  return assemble(std::move(faces), labels);
}

Mesh MapMesh::submesh(std::span<const VertexId> ids) const {
  std::vector<char> wanted(vertices_.size(), 0);
  Aabb box;
  for (VertexId id : ids) {
    if (!alive(id)) continue;
    wanted[slot_of_id_[id]] = 1;
    box.extend(position(id));
  }
  std::vector<Face> faces;
  const auto addFrom = [&](const std::vector<Face>& candidates) {
    for (const Face& face : candidates) {
      if (wanted[face[0]] && wanted[face[1]] && wanted[face[2]]) faces.push_back(face);
    }
  };
  for (const FrozenBlock& block : frozen_) {
    // A frozen face may move within the cells of corners that an active block shares.
    const Aabb reach(block.box.min().array() - merge_resolution_m_,
                     block.box.max().array() + merge_resolution_m_);
    if (reach.intersects(box)) addFrom(block.faces);
  }
  for (const auto& [index, block] : blocks_) addFrom(block.faces);
  return assemble(std::move(faces), nullptr);
}

Mesh MapMesh::assemble(std::vector<Face> faces, std::vector<Label>* labels) const {
  removeDuplicates(faces);
  Mesh mesh;
  if (labels) labels->clear();
  std::vector<Slot> index_of_slot(vertices_.size(), kNoSlot);
  mesh.faces.reserve(faces.size());
  for (const Face& face : faces) {
    Eigen::Vector3i corners;
    for (int k = 0; k < 3; ++k) {
      const Slot slot = face[static_cast<std::size_t>(k)];
      if (index_of_slot[slot] == kNoSlot) {
        index_of_slot[slot] = static_cast<Slot>(mesh.vertices.size());
        mesh.vertices.push_back(vertices_[slot].position);
        mesh.colors.push_back(vertices_[slot].color);
        if (labels) labels->push_back(vertices_[slot].label);
      }
      corners[k] = static_cast<int>(index_of_slot[slot]);
    }
    mesh.faces.push_back(corners);
  }
  return mesh;
}

}  // namespace hydrabench

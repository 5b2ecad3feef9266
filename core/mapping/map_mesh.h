// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <span>
#include <vector>

#include "core/geometry/box.h"
#include "core/geometry/mesh.h"
#include "core/mapping/cell_table.h"
#include "core/mapping/marching_cubes.h"
#include "core/mapping/voxel_grid.h"
#include "core/types/ids.h"

namespace hydrabench {

/// A vertex of the map for as long as it lives; never used again for another.
using VertexId = std::uint32_t;

/// The mesh of the map, put together from the triangles of blocks. Vertices that fall into one cell
/// of the merge grid are one (as in the delta compression of Kimera-PGMO); triangles that lose
/// their area by that are dropped. A vertex is active while a block that uses it is, then frozen;
/// blocks seen again later add vertices of their own. An update costs time in proportion to its
/// block, whatever the size of the map.
class MapMesh {
 public:
  /// Of a block that was archived and is seen again there are two surfaces: both stay, or the one
  /// that was measured better.
  enum class Revisited { kBoth, kBest };
  explicit MapMesh(double merge_resolution_m, Revisited revisited = Revisited::kBoth);

  /// Replaces the triangles of an active block. A vertex that stays in its cell keeps its id and
  /// takes the new position, colour and label; of several in one cell the first counts.
  void update(const BlockIndex& block, const TriangleSoup& triangles);
  /// Freezes the triangles of a block.
  /// @param confidence  how well it was measured, for kBest: the higher the better
  /// @param left        false: its voxels are still there, and more of it may follow
  void archive(const BlockIndex& block, double confidence = 0, bool left = true);

  bool alive(VertexId id) const { return id < slot_of_id_.size() && slot_of_id_[id] != kNoSlot; }
  bool active(VertexId id) const { return alive(id) && vertex(id).users > 0; }  ///< implies alive
  const Eigen::Vector3d& position(VertexId id) const { return vertex(id).position; }
  Label label(VertexId id) const { return vertex(id).label; }
  std::vector<VertexId> activeVertices() const;  ///< ascending

  /// Everything; labels get one entry per vertex. Of triangles with the same three corners one is
  /// left, or none where they face both ways: then they are the two sides of a fold of no volume.
  /// Vertices no triangle uses are left out.
  Mesh mesh(std::vector<Label>* labels = nullptr) const;
  /// The same of the triangles whose three corners are all in `ids` (ascending). Dead ids are
  /// passed over.
  Mesh submesh(std::span<const VertexId> ids) const;

 private:
  using Slot = std::uint32_t;  // place of a vertex in memory, used again after its death
  using Face = std::array<Slot, 3>;
  static constexpr Slot kNoSlot = CellTable::kNone;

  struct Vertex {
    Eigen::Vector3d position = Eigen::Vector3d::Zero();
    Label label = kUnknownLabel;
    VertexId id = 0;
    std::uint32_t users = 0;       // active blocks
    std::uint32_t last_visit = 0;  // number of the update that used it last
    Rgb color;
    bool in_frozen_face = false;
  };
  struct Block {
    std::vector<Slot> vertices;  // each once
    std::vector<Face> faces;
  };
  struct FrozenBlock {
    Aabb box;
    std::vector<Face> faces;
  };
  /// What kBest keeps of a block.
  struct Version {
    std::size_t frozen = 0;  ///< place in frozen_
    double confidence = 0;
    bool complete = false;
  };

  const Vertex& vertex(VertexId id) const;
  Eigen::Vector3i cellOf(const Eigen::Vector3d& position) const;
  Slot slotInCellOf(const Eigen::Vector3d& position);
  void dropUser(Slot slot);
  Mesh assemble(std::vector<Face> faces, std::vector<Label>* labels) const;

  double merge_resolution_m_;
  Revisited revisited_;
  std::vector<Vertex> vertices_;  // by slot
  std::vector<Slot> free_slots_;
  std::vector<Slot> slot_of_id_;
  CellTable cells_;                   // of active vertices
  std::vector<VertexId> recent_ids_;  // ascending: the active ones and some that no longer are
  std::map<BlockIndex, Block, IndexLess> blocks_;
  std::vector<FrozenBlock> frozen_;
  std::map<BlockIndex, Version, IndexLess> versions_;
  std::uint32_t visit_ = 0;
};

}  // namespace hydrabench

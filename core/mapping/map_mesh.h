// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <unordered_map>
#include <vector>

#include "core/geometry/mesh.h"
#include "core/mapping/marching_cubes.h"
#include "core/mapping/voxel_grid.h"
#include "core/types/ids.h"

namespace hydrabench {

/// A vertex of the map for as long as it lives; never used again for another.
using VertexId = std::uint32_t;

/// The mesh of the map, put together from the triangles of blocks. Vertices that fall into one cell
/// of the merge grid are one (PGMO's delta compression). A vertex is active while a
/// block that uses it is, then frozen; blocks seen again later add vertices of their own.
class MapMesh {
 public:
  explicit MapMesh(double merge_resolution_m) : merge_resolution_m_(merge_resolution_m) {}

  /// Replaces the triangles of an active block. A vertex that stays in its cell keeps its id.
  void update(const BlockIndex& block, const TriangleSoup& triangles);
  /// Freezes the triangles of a block.
  void archive(const BlockIndex& block);

  bool alive(VertexId id) const;
  bool active(VertexId id) const;  ///< implies alive
  const Eigen::Vector3d& position(VertexId id) const;
  Label label(VertexId id) const;
  std::vector<VertexId> activeVertices() const;  ///< ascending

  /// Everything; labels get one entry per vertex.
  Mesh mesh(std::vector<Label>* labels = nullptr) const;
  /// The triangles whose three corners are all in `ids` (ascending); vertices no triangle uses are
  /// left out. Dead ids are passed over.
  Mesh submesh(std::span<const VertexId> ids) const;

 private:
  double merge_resolution_m_;
};

}  // namespace hydrabench

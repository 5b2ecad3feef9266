// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <memory>
#include <optional>

#include "core/geometry/mesh.h"
#include "metrics/voxel_set.h"

namespace hydrabench {

/// Before anything is decided, coordinates in units of the pitch within 1e-6 of a multiple of one
/// half are moved onto it. Decimal pitches have no exact binary value (0.15 / 0.05 < 3); without
/// this, the cell of a face on a border would be up to rounding.
///
/// A mesh whose box holds more than kMaxCells cells has no voxel set (nullopt): at the default
/// pitch that is 16 000 m^3, beyond any object, and would only exhaust the memory.
inline constexpr std::size_t kMaxCells = std::size_t{1} << 27;

/// Fills meshes: a cell belongs to the solid if its centre has a generalised winding number above
/// 1/2. Only cells inside the AABB of the mesh are asked.
///
/// Where every directed edge is balanced by its reverse (all watertight meshes, and unions of them)
/// that number is an integer: it is counted by signed crossings along columns, with each crossing
/// half-open like the cells, so that neighbouring triangles never both or neither count; and a mesh
/// turned inside out (negative volume) is turned back. All other meshes go through core/geometry's
/// WindingNumber, at a thousand times the cost per cell.
class SolidVoxelizer {
 public:
  explicit SolidVoxelizer(const Mesh& mesh);
  ~SolidVoxelizer();
  SolidVoxelizer(SolidVoxelizer&&) noexcept;
  SolidVoxelizer& operator=(SolidVoxelizer&&) noexcept;

  /// Thread-safe. Empty for a mesh without faces.
  std::optional<VoxelSet> voxelize(const VoxelLattice& grid) const;
  bool countsCrossings() const;  ///< the mesh bounds a volume, so the fast way is taken

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// All cells in bounds asked one by one, with WindingNumber::exactAt: the reference for
/// SolidVoxelizer. Slow.
VoxelSet solidVoxelsReference(const Mesh& mesh, const VoxelLattice& grid);

/// The cells that the surface touches: exact triangle-box overlap by separating axes
/// (Akenine-Moeller, JGT 2001), with half-open cells, so that a face on a border belongs to the
/// cells above it only. Faces without area mark the cells of their edges.
std::optional<VoxelSet> surfaceVoxels(const Mesh& mesh, const VoxelLattice& grid);

}  // namespace hydrabench

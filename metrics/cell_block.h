// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "core/geometry/mesh.h"
#include "metrics/voxel_set.h"

namespace hydrabench {

/// Vertices in units of the pitch from the grid's origin; within 1e-6 of a multiple of one half
/// they are moved onto it (voxelize.h).
std::vector<Eigen::Vector3d> inCellUnits(const std::vector<Eigen::Vector3d>& vertices,
                                         const VoxelLattice& grid);

/// The block of cells around the vertices of a mesh: workspace of the voxelizers.
struct CellBlock {
  Eigen::Array3i first = Eigen::Array3i::Zero();
  Eigen::Array3i size = Eigen::Array3i::Zero();  ///< cells along x, y, z

  std::size_t cells() const;
  /// Position of cell (x, y, z) in an array that runs along z first; each coordinate inside the
  /// block.
  std::size_t index(int x, int y, int z) const {
    return (static_cast<std::size_t>(x - first.x()) * static_cast<std::size_t>(size.y()) +
            static_cast<std::size_t>(y - first.y())) *
               static_cast<std::size_t>(size.z()) +
           static_cast<std::size_t>(z - first.z());
  }
};

/// All cells that the box around the faces' vertices touches (vertices in cell units). nullopt:
/// more than kMaxCells.
std::optional<CellBlock> blockAround(const std::vector<Eigen::Vector3d>& vertices,
                                     const std::vector<Eigen::Vector3i>& faces);

/// The cells of the block where is_set(index) holds.
template <typename IsSet>
VoxelSet collectRuns(const CellBlock& block, const IsSet& is_set) {
  std::vector<VoxelSet::Run> runs;
  std::size_t index = 0;
  const Eigen::Array3i end = block.first + block.size;
  for (int x = block.first.x(); x < end.x(); ++x) {
    for (int y = block.first.y(); y < end.y(); ++y) {
      bool inside = false;
      for (int z = block.first.z(); z < end.z(); ++z, ++index) {
        const bool set = is_set(index);
        if (set && !inside) runs.push_back({x, y, z, end.z()});
        if (!set && inside) runs.back().z_end = z;
        inside = set;
      }
    }
  }
  return VoxelSet(std::move(runs));
}

}  // namespace hydrabench

// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "metrics/cell_block.h"

#include <cmath>

#include "metrics/voxelize.h"

namespace hydrabench {

std::vector<Eigen::Vector3d> inCellUnits(const std::vector<Eigen::Vector3d>& vertices,
                                         const VoxelLattice& grid) {
  std::vector<Eigen::Vector3d> result(vertices.size());
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    for (int axis = 0; axis < 3; ++axis) {
      const double u = (vertices[i][axis] - grid.origin[axis]) / grid.pitch_m;
      const double half = 0.5 * std::floor(2 * u + 0.5);
      result[i][axis] = std::abs(u - half) < 1e-6 ? half : u;
    }
  }
  return result;
}

std::size_t CellBlock::cells() const {
  return static_cast<std::size_t>(size.x()) * static_cast<std::size_t>(size.y()) *
         static_cast<std::size_t>(size.z());
}

std::optional<CellBlock> blockAround(const std::vector<Eigen::Vector3d>& vertices,
                                     const std::vector<Eigen::Vector3i>& faces) {
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3i& face : faces) {
    for (const int vertex : face) box.extend(vertices[static_cast<std::size_t>(vertex)]);
  }
  if (box.isEmpty()) return CellBlock{};
  const Eigen::Array3d low = box.min().array().floor();
  const Eigen::Array3d size = box.max().array().floor() - low + 1;
  constexpr double kFarthest = 1e9;  // run ends are 32-bit
  if (!(size.prod() <= static_cast<double>(kMaxCells)) || !(low.abs() < kFarthest).all()) {
    return std::nullopt;
  }
  return CellBlock{low.cast<int>(), size.cast<int>()};
}

}  // namespace hydrabench

// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

#include <Eigen/Core>

namespace hydrabench {

// Words for places in a map. World: metres. Voxel (global): whole voxels from the world's origin.
// Block: a cube of side^3 voxels. Local: a voxel's number inside its block, x fastest.

using BlockIndex = Eigen::Vector3i;
using GlobalVoxel = Eigen::Vector3i;

struct IndexHash {
  std::size_t operator()(const Eigen::Vector3i& i) const {
    std::uint64_t h = static_cast<std::uint32_t>(i.x()) * 0x9e3779b97f4a7c15ull;
    h = (h ^ (h >> 29)) + static_cast<std::uint32_t>(i.y()) * 0xbf58476d1ce4e5b9ull;
    h = (h ^ (h >> 31)) + static_cast<std::uint32_t>(i.z()) * 0x94d049bb133111ebull;
    return h ^ (h >> 32);
  }
};
/// x, then y, then z: the order in which results are listed.
struct IndexLess {
  bool operator()(const Eigen::Vector3i& a, const Eigen::Vector3i& b) const {
    if (a.x() != b.x()) return a.x() < b.x();
    if (a.y() != b.y()) return a.y() < b.y();
    return a.z() < b.z();
  }
};

/// Largest whole number not above each coordinate, which an int must hold. Without std::floor, a
/// call into the library on plain x86-64.
inline Eigen::Vector3i floored(const Eigen::Vector3d& p) {
  const Eigen::Vector3i toward_zero(static_cast<int>(p.x()), static_cast<int>(p.y()),
                                    static_cast<int>(p.z()));
  return {toward_zero.x() - (p.x() < toward_zero.x()), toward_zero.y() - (p.y() < toward_zero.y()),
          toward_zero.z() - (p.z() < toward_zero.z())};
}

/// Geometry of a grid of voxels in blocks; the centre of voxel i lies at (i + 0.5) voxel sizes.
struct VoxelGrid {
  double voxel_size = 0.1;  ///< [m]
  int side = 16;            ///< voxels along the edge of a block

  double blockSize() const { return voxel_size * side; }  ///< [m]
  std::size_t voxelsPerBlock() const {
    return static_cast<std::size_t>(side) * static_cast<std::size_t>(side) *
           static_cast<std::size_t>(side);
  }
  GlobalVoxel voxelAt(const Eigen::Vector3d& point) const { return floored(point / voxel_size); }
  BlockIndex blockAt(const Eigen::Vector3d& point) const { return blockOf(voxelAt(point)); }
  BlockIndex blockOf(const GlobalVoxel& voxel) const {
    return {floorDivide(voxel.x()), floorDivide(voxel.y()), floorDivide(voxel.z())};
  }
  std::size_t localOf(const GlobalVoxel& voxel) const {
    const Eigen::Vector3i local = voxel - side * blockOf(voxel);
    return localIndex(local.x(), local.y(), local.z());
  }
  std::size_t localIndex(int x, int y, int z) const {
    return static_cast<std::size_t>((z * side + y) * side + x);
  }
  GlobalVoxel globalOf(const BlockIndex& block, std::size_t local) const {
    const int i = static_cast<int>(local);
    return side * block + Eigen::Vector3i(i % side, i / side % side, i / (side * side));
  }
  Eigen::Vector3d centerOf(const GlobalVoxel& voxel) const {
    return (voxel.cast<double>().array() + 0.5).matrix() * voxel_size;
  }
  Eigen::Vector3d centerOfBlock(const BlockIndex& block) const {
    return (block.cast<double>().array() + 0.5).matrix() * blockSize();
  }

 private:
  int floorDivide(int i) const { return i >= 0 ? i / side : -((-i + side - 1) / side); }
};

}  // namespace hydrabench

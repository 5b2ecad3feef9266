// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <Eigen/Core>

namespace hydrabench {

/// A lattice of cubic cells over all of space. Cell (i, j, k) covers [i, i+1) x [j, j+1) x [k, k+1)
/// in units of the pitch from the origin: half-open, so every point lies in exactly one cell.
struct VoxelLattice {
  double pitch_m = 0.05;                             ///< edge of a cell [m], above 0
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();  ///< corner of cell (0, 0, 0) [m]
};

/// The grid itself and `count` copies whose origins are moved by up to one pitch along each axis.
/// Deterministic for a seed.
std::vector<VoxelLattice> jitteredGrids(const VoxelLattice& grid, std::size_t count,
                                        std::uint64_t seed);

/// A set of cells of one grid as runs along z: small, and quick to intersect. Sets of different
/// grids must not be mixed.
class VoxelSet {
 public:
  /// Cells (x, y, z_begin) to (x, y, z_end - 1).
  struct Run {
    std::int32_t x = 0;
    std::int32_t y = 0;
    std::int32_t z_begin = 0;
    std::int32_t z_end = 0;
    friend bool operator==(const Run&, const Run&) = default;
  };

  VoxelSet() = default;
  explicit VoxelSet(std::vector<Run> runs);  ///< ascending in (x, y, z), not touching, not empty

  std::size_t count() const { return count_; }
  bool contains(int x, int y, int z) const;
  std::span<const Run> runs() const { return runs_; }
  friend bool operator==(const VoxelSet&, const VoxelSet&) = default;

 private:
  std::vector<Run> runs_;
  std::size_t count_ = 0;
};

std::size_t intersectionCount(const VoxelSet& a, const VoxelSet& b);

/// Cells in both over cells in either. No unit, [0, 1], higher is better. One set empty: 0. Both
/// empty: undefined.
std::optional<double> voxelIou(const VoxelSet& a, const VoxelSet& b);

/// What the choice of the grid's origin does to a score.
struct OriginSpread {
  double mean = 0;
  double deviation = 0;  ///< root of the mean squared deviation from the mean
  double min = 0;
  double max = 0;
};
/// Over the values of one pair on several grids. None, or one that is undefined: undefined.
std::optional<OriginSpread> originSpread(std::span<const std::optional<double>> values);

}  // namespace hydrabench

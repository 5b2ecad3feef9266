// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "core/mapping/freespace.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "core/parallel/parallel_for.h"

namespace hydrabench {
namespace {

/// What is fixed during one update.
struct Moment {
  float occupied_distance_m = 0;
  std::int64_t stamp_ns = 0;
  std::int64_t free_before_ns = 0;  ///< free if last occupied before this
};

/// Free now, or once and for all. The distance is asked too, because a voxel of a block that left
/// the view keeps the time at which it was last seen full.
bool isFree(const TsdfVoxel& tsdf, const FreespaceVoxel& voxel, const Moment& now) {
  if (voxel.ever_free) return true;
  return tsdf.weight > 0 && tsdf.distance >= now.occupied_distance_m &&
         (voxel.last_occupied_ns == 0 || voxel.last_occupied_ns < now.free_before_ns);
}

using Flags = std::vector<std::uint8_t>;  ///< one per voxel of a block: 1 where free

void markOccupied(const Moment& now, VoxelBlock& block) {
  block.freespace.resize(block.voxels.size());
  // 0 means never, so a dataset's first instant may not be 0.
  const std::int64_t stamp_ns = std::max<std::int64_t>(now.stamp_ns, 1);
  for (std::size_t i = 0; i < block.voxels.size(); ++i) {
    if (!(block.voxels[i].weight > 0)) continue;
    if (block.voxels[i].distance < now.occupied_distance_m) {
      block.freespace[i].last_occupied_ns = stamp_ns;
    }
  }
}

Flags freeFlags(const Moment& now, const VoxelBlock& block) {
  Flags free(block.voxels.size());
  for (std::size_t i = 0; i < free.size(); ++i) {
    free[i] = isFree(block.voxels[i], block.freespace[i], now);
  }
  return free;
}

/// A block's flags with a border of one voxel taken from its neighbours; 0 where there is none.
class PaddedFlags {
 public:
  explicit PaddedFlags(int side)
      : width_(side + 2), flags_(static_cast<std::size_t>(width_ * width_ * width_)) {}

  /// Local coordinates, from -1 to side.
  std::uint8_t* row(int y, int z) { return &flags_[at(y, z)]; }
  const std::uint8_t* row(int y, int z) const { return &flags_[at(y, z)]; }

 private:
  /// Of x = 0.
  std::size_t at(int y, int z) const {
    return static_cast<std::size_t>(((z + 1) * width_ + y + 1) * width_ + 1);
  }

  int width_;
  Flags flags_;
};

/// Range of local coordinates of the neighbour at `offset` (-1, 0 or 1) that touches the block.
struct Span {
  int begin = 0;
  int end = 0;
};
Span touching(int offset, int side) {
  if (offset < 0) return {side - 1, side};
  return {0, offset > 0 ? 1 : side};
}

template <typename IsFree>
void copyBorder(const VoxelGrid& grid, const Eigen::Vector3i& offset, const IsFree& is_free,
                PaddedFlags& padded) {
  const Span xs = touching(offset.x(), grid.side);
  const Span ys = touching(offset.y(), grid.side);
  const Span zs = touching(offset.z(), grid.side);
  for (int z = zs.begin; z < zs.end; ++z) {
    for (int y = ys.begin; y < ys.end; ++y) {
      std::uint8_t* row = padded.row(y + offset.y() * grid.side, z + offset.z() * grid.side);
      for (int x = xs.begin; x < xs.end; ++x) {
        row[x + offset.x() * grid.side] = is_free(grid.localIndex(x, y, z));
      }
    }
  }
}

/// Marks voxels that are free with their 18 neighbours: those that differ in one or two
/// coordinates.
void markEverFree(const PaddedFlags& free, int side, VoxelBlock& block) {
  Flags all(static_cast<std::size_t>(side));
  std::size_t i = 0;
  for (int z = 0; z < side; ++z) {
    for (int y = 0; y < side; ++y) {
      std::fill(all.begin(), all.end(), std::uint8_t{1});
      for (int dz = -1; dz <= 1; ++dz) {
        for (int dy = -1; dy <= 1; ++dy) {
          const std::uint8_t* row = free.row(y + dy, z + dz);
          for (int x = 0; x < side; ++x) all[static_cast<std::size_t>(x)] &= row[x];
          if (dy != 0 && dz != 0) continue;  // the corners are no neighbours
          for (int x = 0; x < side; ++x) {
            all[static_cast<std::size_t>(x)] &= row[x - 1] & row[x + 1];
          }
        }
      }
      for (int x = 0; x < side; ++x, ++i) {
        if (all[static_cast<std::size_t>(x)]) block.freespace[i].ever_free = true;
      }
    }
  }
}

}  // namespace

void FreespaceTracker::update(std::span<const BlockIndex> blocks, std::int64_t stamp_ns,
                              TsdfVolume& volume) const {
  const VoxelGrid& grid = volume.grid();
  const Moment now{static_cast<float>(config_.occupied_distance_voxels * grid.voxel_size), stamp_ns,
                   stamp_ns - std::llround(config_.free_after_s * 1e9)};

  // First what every block knows of itself, then what takes its neighbours: no block is written
  // while another reads it.
  std::vector<Flags> free(blocks.size());
  parallelFor(blocks.size(), [&](std::size_t i) {
    VoxelBlock& block = *volume.find(blocks[i]);
    markOccupied(now, block);
    free[i] = freeFlags(now, block);
  });

  std::unordered_map<BlockIndex, const Flags*, IndexHash> updated;
  for (std::size_t i = 0; i < blocks.size(); ++i) updated[blocks[i]] = &free[i];
  parallelFor(blocks.size(), [&](std::size_t i) {
    PaddedFlags padded(grid.side);
    for (int dz = -1; dz <= 1; ++dz) {
      for (int dy = -1; dy <= 1; ++dy) {
        for (int dx = -1; dx <= 1; ++dx) {
          if (dx != 0 && dy != 0 && dz != 0) continue;
          const Eigen::Vector3i offset(dx, dy, dz);
          const BlockIndex index = blocks[i] + offset;
          const auto flags = updated.find(index);
          if (flags != updated.end()) {
            const Flags& own = *flags->second;
            copyBorder(
                grid, offset, [&](std::size_t local) { return own[local]; }, padded);
            continue;
          }
          const VoxelBlock* neighbor = volume.find(index);
          if (!neighbor || neighbor->freespace.empty()) continue;
          copyBorder(
              grid, offset,
              [&](std::size_t local) {
                return isFree(neighbor->voxels[local], neighbor->freespace[local], now);
              },
              padded);
        }
      }
    }
    markEverFree(padded, grid.side, *volume.find(blocks[i]));
  });
}

void read(ConfigReader& reader, FreespaceTracker::Config& config) {
  reader.field("occupied_distance_voxels", config.occupied_distance_voxels, Bounds{0, 100});
  reader.field("free_after_s", config.free_after_s, Bounds{0, 1e6});
}

}  // namespace hydrabench

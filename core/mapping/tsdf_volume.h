// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <memory>
#include <unordered_map>
#include <vector>

#include "core/config/config_reader.h"
#include "core/mapping/semantic_fusion.h"
#include "core/mapping/voxel_grid.h"
#include "core/types/color.h"

namespace hydrabench {

struct TsdfVoxel {
  float distance = 0;        ///< signed, along viewing rays [m]; positive in front of the surface
  float weight = 0;          ///< 0: never measured
  Rgb color;                 ///< black until a measurement near the surface brings one
  bool colored : 1 = false;  ///< these two take the byte that would be padding
  bool assumed : 1 = false;  ///< by the ground band alone: nothing was measured here
};

/// When a voxel was seen to be full, and whether it was empty (Khronos).
struct FreespaceVoxel {
  std::int64_t last_occupied_ns = 0;  ///< 0: never
  bool ever_free = false;             ///< was empty, with all its neighbours, for long enough
};

struct VoxelBlock {
  std::vector<TsdfVoxel> voxels;
  std::unique_ptr<SemanticBlock> semantics;  ///< may be null
  std::vector<FreespaceVoxel> freespace;     ///< empty unless free space is tracked
  std::int64_t last_updated_ns = 0;
  bool mesh_outdated = false;  ///< changed since the mesh was taken
  bool left_window = false;    ///< and was not measured since, see ActiveWindow
};

/// Signed distances in hashed blocks of voxels (Niessner et al., ACM TOG 2013).
class TsdfVolume {
 public:
  struct Config {
    double voxel_size_m = 0.1;
    double truncation_m = 0.3;  ///< half width of the band around the surface
    int voxels_per_side = 16;
    SemanticFusionConfig semantics;
  };
  explicit TsdfVolume(const Config& config);

  const Config& config() const { return config_; }
  const VoxelGrid& grid() const { return grid_; }
  std::size_t numBlocks() const { return blocks_.size(); }
  std::vector<BlockIndex> blockIndices() const;  ///< in order of IndexLess
  VoxelBlock* find(const BlockIndex& index);
  const VoxelBlock* find(const BlockIndex& index) const;
  VoxelBlock& allocate(const BlockIndex& index);  ///< the one there is, or a new empty one
  void remove(const BlockIndex& index);
  /// nullptr where the block does not exist.
  const TsdfVoxel* voxel(const GlobalVoxel& voxel) const;

 private:
  Config config_;
  VoxelGrid grid_;
  std::unordered_map<BlockIndex, std::unique_ptr<VoxelBlock>, IndexHash> blocks_;
};

/// Keys voxel_size_m, truncation_m, voxels_per_side, semantics.
void read(ConfigReader& reader, TsdfVolume::Config& config);

}  // namespace hydrabench

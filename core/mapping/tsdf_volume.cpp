// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "core/mapping/tsdf_volume.h"

#include <algorithm>
#include <cassert>

namespace hydrabench {

TsdfVolume::TsdfVolume(const Config& config)
    : config_(config), grid_{config.voxel_size_m, config.voxels_per_side} {
  assert(config.voxel_size_m > 0 && config.truncation_m > 0 && config.voxels_per_side > 0);
}

std::vector<BlockIndex> TsdfVolume::blockIndices() const {
  std::vector<BlockIndex> indices;
  indices.reserve(blocks_.size());
  for (const auto& [index, block] : blocks_) indices.push_back(index);
  std::sort(indices.begin(), indices.end(), IndexLess{});
  return indices;
}

VoxelBlock* TsdfVolume::find(const BlockIndex& index) {
  const auto it = blocks_.find(index);
  return it == blocks_.end() ? nullptr : it->second.get();
}

const VoxelBlock* TsdfVolume::find(const BlockIndex& index) const {
  const auto it = blocks_.find(index);
  return it == blocks_.end() ? nullptr : it->second.get();
}

VoxelBlock& TsdfVolume::allocate(const BlockIndex& index) {
  std::unique_ptr<VoxelBlock>& block = blocks_[index];
  if (!block) {
    block = std::make_unique<VoxelBlock>();
    block->voxels.resize(grid_.voxelsPerBlock());
    block->semantics = makeSemanticBlock(config_.semantics, grid_.voxelsPerBlock());
  }
  return *block;
}

void TsdfVolume::remove(const BlockIndex& index) { blocks_.erase(index); }

const TsdfVoxel* TsdfVolume::voxel(const GlobalVoxel& voxel) const {
  const VoxelBlock* block = find(grid_.blockOf(voxel));
  return block == nullptr ? nullptr : &block->voxels[grid_.localOf(voxel)];
}

void read(ConfigReader& reader, TsdfVolume::Config& config) {
  reader.field("voxel_size_m", config.voxel_size_m, {0.001, 10});
  reader.field("truncation_m", config.truncation_m, {0.001, 100});
  reader.field("voxels_per_side", config.voxels_per_side,
               {2, 63});  // rows of marching cubes: 64 bits
  if (config.truncation_m < config.voxel_size_m)
    reader.fault("truncation_m", "is below voxel_size_m; expected at least one voxel");
  auto semantics = reader.section("semantics");
  read(semantics, config.semantics);
}

}  // namespace hydrabench

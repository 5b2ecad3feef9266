// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>

#include "core/mapping/tsdf_volume.h"

namespace hydrabench {

/// Blocks from `low` to `high`, all voxels of weight 1 with the distance that the function gives at
/// their centres.
inline TsdfVolume filledVolume(const TsdfVolume::Config& config, const BlockIndex& low,
                               const BlockIndex& high,
                               const std::function<double(const Eigen::Vector3d&)>& distance) {
  TsdfVolume volume(config);
  for (int z = low.z(); z <= high.z(); ++z) {
    for (int y = low.y(); y <= high.y(); ++y) {
      for (int x = low.x(); x <= high.x(); ++x) {
        VoxelBlock& block = volume.allocate({x, y, z});
        block.mesh_outdated = true;
        for (std::size_t i = 0; i < block.voxels.size(); ++i) {
          const GlobalVoxel voxel = volume.grid().globalOf({x, y, z}, i);
          block.voxels[i].distance = static_cast<float>(distance(volume.grid().centerOf(voxel)));
          block.voxels[i].weight = 1;
        }
      }
    }
  }
  return volume;
}

}  // namespace hydrabench

// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>

#include "core/config/config_reader.h"
#include "core/mapping/tsdf_volume.h"

namespace hydrabench {

/// Keeps, per voxel, when it was last full, and whether it was ever reliably empty
/// (Khronos; after Schmid et al., "Dynablox", RA-L 2023). Ever-free is for good, until the block is
/// archived.
class FreespaceTracker {
 public:
  struct Config {
    double occupied_distance_voxels = 1.5;  ///< full where the distance is below this
    double free_after_s = 1;  ///< a voxel that was full is free again when it was empty this long;
                              ///< one that never was full is free at once
  };
  explicit FreespaceTracker(const Config& config) : config_(config) {}

  /// Updates the measured voxels of the blocks that a frame changed; what was seen is known to the
  /// block. A voxel becomes ever-free when it and its 18 neighbours (faces and edges) are free or
  /// ever-free. In parallel over blocks; results do not depend on the number of threads.
  /// @param blocks  those that TsdfIntegrator::integrate returned
  void update(std::span<const BlockIndex> blocks, std::int64_t stamp_ns, TsdfVolume& volume) const;

 private:
  Config config_;
};

void read(ConfigReader& reader, FreespaceTracker::Config& config);

}  // namespace hydrabench

// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "core/config/config_reader.h"
#include "core/mapping/sensor_view.h"
#include "core/mapping/tsdf_volume.h"

namespace hydrabench {

/// Fuses range images into a TSDF by projecting voxels into the image, as Hydra and Khronos do
/// (Curless and Levoy, SIGGRAPH 1996). The signed
/// distance of a voxel is measured range minus its own range, along the ray. In parallel over
/// blocks; results do not depend on the number of threads.
class TsdfIntegrator {
 public:
  struct Config {
    /// nearest, bilinear, or adaptive: bilinear unless the four ranges around the projection differ
    /// by more than max_range_difference_m.
    std::string interpolation = "adaptive";
    double max_range_difference_m = 0.2;
    bool constant_weight = false;  ///< leave out the 1/depth^2 of the sensor noise
    bool weight_dropoff = true;    ///< weight falls to 0 across the band behind the surface
    double dropoff_start_voxels = 1;
    double min_weight = 1e-4;  ///< of one measurement
    double max_weight = 1e5;   ///< of a voxel
  };
  explicit TsdfIntegrator(const Config& config) : config_(config) {}

  /// Updates every voxel in view, allocating blocks; blocks that got no measurement are not kept.
  /// @return  blocks that changed, in order of IndexLess
  std::vector<BlockIndex> integrate(const SensorView& view, TsdfVolume& volume) const;

  /// Updates the given blocks, which must exist, and no others: for a volume around one object.
  void integrateBlocks(const SensorView& view, std::span<const BlockIndex> blocks,
                       TsdfVolume& volume) const;

 private:
  Config config_;
};

void read(ConfigReader& reader, TsdfIntegrator::Config& config);

}  // namespace hydrabench

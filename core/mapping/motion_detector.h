// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "core/config/config_reader.h"
#include "core/mapping/sensor_view.h"
#include "core/mapping/tsdf_volume.h"

namespace hydrabench {

/// Moving things of one frame.
struct MotionDetection {
  Image<std::uint8_t> ids;  ///< 0: static; else the number of the cluster + 1
  struct Cluster {
    std::vector<std::uint32_t> pixels;  ///< row-major indices, ascending
  };
  std::vector<Cluster> clusters;
};

/// Finds what is where space was known to be empty (Khronos' FreeSpaceMotionDetector): voxels that
/// hold points of this frame and are ever-free are seeds; 26-connected seeds form a cluster; other
/// voxels with points that touch a seed join it; clusters with voxels near each other are merged.
class MotionDetector {
 public:
  struct Config {
    bool enabled = true;
    int min_pixels = 500;
    int max_pixels = 1000000;
    double min_separation_voxels = 2;  ///< clusters with voxel centres closer than this are one
    double max_range_m = 5;            ///< farther points are passed over
  };
  explicit MotionDetector(const Config& config) : config_(config) {}

  /// Clusters are listed in the order of their first seed's pixel; beyond 255 none is.
  /// @param volume  with free space tracked, before this frame is integrated
  /// @return        `ids` always has the size of the view's image
  MotionDetection detect(const SensorView& view, const TsdfVolume& volume) const;

 private:
  Config config_;
};

void read(ConfigReader& reader, MotionDetector::Config& config);

}  // namespace hydrabench

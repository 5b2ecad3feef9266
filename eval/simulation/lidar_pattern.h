// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "core/geometry/lidar_model.h"

namespace hydrabench {

/// Where the lasers of a spinning LiDAR point. They all fire at once, `columns` times a turn;
/// column c looks where column c of LidarModel looks, at the share c / columns of the sweep.
struct LidarPattern {
  int columns = 0;
  std::vector<double> elevations_rad;  ///< of each laser, from the highest down

  /// The image that a method is told of: as many equal rows between the highest and the lowest
  /// laser as there are lasers.
  LidarModel model() const;

  /// Velodyne VLP-16: 16 lasers from 15 to -15 degrees.
  static LidarPattern vlp16();
  /// Velodyne HDL-64E: 32 lasers from 2 to -8.33 degrees, a third of a degree apart, and 32 from
  /// -8.83 to -24.33, half a degree apart. Its equal rows are 0.42 degrees apart: some of the upper
  /// ones see two lasers, some of the lower ones none.
  static LidarPattern hdl64();
};

/// "vlp16" or "hdl64".
LidarPattern lidarPattern(const std::string& name);
const std::vector<std::string>& lidarPatternNames();

}  // namespace hydrabench

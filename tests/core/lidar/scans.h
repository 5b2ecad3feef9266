// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <limits>
#include <numbers>

#include "core/types/lidar_scan.h"

namespace hydrabench {

/// 16 rows from 15 degrees above the horizon to 15 below, 2 degrees apart; one column a degree.
inline LidarModel sixteenRows() {
  constexpr double kDegree = std::numbers::pi / 180;
  return {.columns = 360, .rows = 16, .top_rad = 15 * kDegree, .bottom_rad = -15 * kDegree};
}

/// What the sensor measures, all at once, of ground at -height_m and of nothing else.
inline LidarScan scanOfGround(double height_m, double max_range_m = 40) {
  LidarScan scan;
  scan.stamp_ns = scan.start_ns = 1;
  scan.lidar = sixteenRows();
  scan.T_world_lidar.translation().z() = height_m;
  scan.T_world_lidar_start = scan.T_world_lidar;
  for (int v = 0; v < scan.lidar.rows; ++v) {
    for (int u = 0; u < scan.lidar.columns; ++u) {
      const Eigen::Vector3d ray = scan.lidar.direction(u, v);
      const double range = ray.z() < 0 ? -height_m / ray.z() : max_range_m + 1;
      if (range > max_range_m) continue;
      scan.points.push_back((range * ray).cast<float>());
      scan.rings.push_back(static_cast<std::uint16_t>(v));
    }
  }
  return scan;
}

}  // namespace hydrabench

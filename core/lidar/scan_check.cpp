// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "core/lidar/scan_check.h"

#include <algorithm>
#include <numbers>
#include <string>

#include <fmt/format.h>

#include "core/types/error.h"

namespace hydrabench {
namespace {

[[noreturn]] void fail(const LidarScan& scan, const std::string& what) {
  throw InputError(fmt::format("the lidar scan at {} ns {}", scan.stamp_ns, what));
}

void requireLength(const LidarScan& scan, const char* name, std::size_t length) {
  if (length == 0 || length == scan.points.size()) return;
  fail(scan, fmt::format("has {} entries in '{}'; expected {}, one per point, or none", length,
                         name, scan.points.size()));
}

}  // namespace

void requireUsable(const LidarScan& scan) {
  const LidarModel& lidar = scan.lidar;
  if (lidar.rows < 2 || lidar.columns < 4) {
    fail(scan, fmt::format("is of a sensor with {} rows and {} columns; expected at least 2 and 4",
                           lidar.rows, lidar.columns));
  }
  constexpr double kRightAngle = std::numbers::pi / 2;
  if (!(lidar.bottom_rad < lidar.top_rad && lidar.top_rad <= kRightAngle &&
        lidar.bottom_rad >= -kRightAngle)) {
    fail(scan, fmt::format("is of a sensor with rows from {:g} down to {:g} rad; expected angles "
                           "above the horizon from pi/2 to -pi/2, the first the higher",
                           lidar.top_rad, lidar.bottom_rad));
  }
  requireLength(scan, "intensity", scan.intensity.size());
  requireLength(scan, "rings", scan.rings.size());
  requireLength(scan, "times", scan.times.size());
  requireLength(scan, "labels", scan.labels.size());
  const auto ring = std::max_element(scan.rings.begin(), scan.rings.end());
  if (ring != scan.rings.end() && *ring >= lidar.rows) {
    fail(scan,
         fmt::format("has a point of ring {}; expected rings below {}, the rows of the sensor",
                     *ring, lidar.rows));
  }
  for (const float time : scan.times) {
    if (time >= 0.0f && time <= 1.0f) continue;
    fail(scan, fmt::format("has a point at {:g} of the sweep; expected 0 to 1", time));
  }
  if (scan.start_ns > scan.stamp_ns) {
    fail(scan, fmt::format("starts at {} ns; expected a time not after its end", scan.start_ns));
  }
  if (!scan.T_world_lidar.matrix().allFinite() || !scan.T_world_lidar_start.matrix().allFinite()) {
    fail(scan, "has a pose that is not finite");
  }
}

}  // namespace hydrabench

// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "core/geometry/lidar_model.h"
#include "core/geometry/transform.h"
#include "core/types/ids.h"

namespace hydrabench {

/// One sweep of a LiDAR. The lists that are not empty have one entry per point.
struct LidarScan {
  std::int64_t stamp_ns = 0;  ///< end of the sweep
  std::int64_t start_ns = 0;  ///< of the sweep; stamp_ns where all was measured at once
  LidarModel lidar;
  Transform T_world_lidar = Transform::Identity();        ///< at stamp_ns, as given by odometry
  Transform T_world_lidar_start = Transform::Identity();  ///< at start_ns, likewise
  /// [m] in the frame that the sensor had when it measured the point: x forward, z up. Points that
  /// are not finite, or lie at the origin as drivers write a missing return, are passed over.
  std::vector<Eigen::Vector3f> points;
  std::vector<float> intensity;      ///< 0 to 1; empty: not measured
  std::vector<std::uint16_t> rings;  ///< which laser, 0 the highest; empty: not known
  /// When a point was measured: 0 at start_ns, 1 at stamp_ns. Empty: all points are in the frame of
  /// stamp_ns already.
  std::vector<float> times;
  std::vector<Label> labels;  ///< kUnknownLabel where none is known; empty: none is
};

}  // namespace hydrabench

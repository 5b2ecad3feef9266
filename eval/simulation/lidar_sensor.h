// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "core/config/config_reader.h"
#include "core/geometry/pose_interpolation.h"
#include "core/types/lidar_scan.h"
#include "eval/simulation/rgbd_renderer.h"

namespace hydrabench {

/// A spinning LiDAR on the robot and everything that goes wrong in it.
struct LidarSensorConfig {
  bool enabled = false;
  std::string pattern = "vlp16";  ///< a name of lidarPatternNames()
  double rate_hz = 10;            ///< turns a second
  double offset_s = 0.03;         ///< the first turn ends so long after the first frame
  bool ego_motion = true;         ///< false: all points of a turn are measured at its end
  bool labels = false;            ///< true: every point comes with its true class
  /// T_body_lidar. The body stands on the ground under the camera, x where the camera looks, z up.
  Eigen::Vector3d translation_m = {0, 0, 0.5};
  double roll_deg = 0;       ///< about x, applied first
  double pitch_deg = 0;      ///< about y, down positive
  double yaw_deg = 0;        ///< about z, applied last
  double min_range_m = 0.5;  ///< what is nearer returns nothing
  double max_range_m = 100;
  double range_noise_m = 0.03;     ///< deviation
  double range_quantum_m = 0.002;  ///< 0: none
  /// A white surface hit head-on returns just enough light at this range. Others return
  /// reflectance x cos(incidence) / range^2 of it, and are lost where that is too little. 0:
  /// nothing is lost for lack of light.
  double white_range_m = 420;
  double signal_fluctuation = 0.3;  ///< deviation of the logarithm of the returned light
  double random_dropout = 0.005;    ///< probability of losing any return

  /// @param preset  "clean" (nothing is lost, ranges are exact), "default" or "hard"
  static LidarSensorConfig forPattern(const std::string& pattern, const std::string& preset);
  Transform T_body_lidar() const;
};
/// Keys that are absent have the values of the pattern and the preset.
void read(ConfigReader& reader, const std::string& preset, LidarSensorConfig& config);

/// One turn through a scene, every column cast from where the sensor was at its time, onto movers
/// where they were then: a pure function of (scene, poses, times, config, seed). Points come in the
/// order they were measured; beams without a return are left out. Intensity is reflectance x
/// cos(incidence). The reported poses are left to the caller.
///
/// @param body_poses  where the robot truly was; they must reach from start_ns to stamp_ns
/// @param start_ns    of the turn; stamp_ns where the sensor measures all at once
LidarScan sweep(const RgbdRenderer& renderer, std::span<const TimedPose> body_poses,
                std::int64_t start_ns, std::int64_t stamp_ns, const LidarSensorConfig& config,
                std::uint64_t seed);

}  // namespace hydrabench

// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "eval/datasets/dataset.h"
#include "eval/simulation/lidar_sensor.h"

namespace hydrabench {

/// The LiDAR of a robot whose camera takes the frames of a dataset. Turns follow each other without
/// a gap, at times of their own: between frames the robot's poses, true and reported, are
/// interpolated.
class SimulatedLidar {
 public:
  /// @param trajectory      true poses of the camera
  /// @param reported_poses  of the camera, as odometry gives them; one per pose of the trajectory
  SimulatedLidar(const LidarSensorConfig& config, const std::vector<StampedPose>& trajectory,
                 const std::vector<Transform>& reported_poses, const Transform& T_body_camera,
                 std::uint64_t seed);

  /// Turns that end after frame `index` - 1 and not after frame `index`. A turn that began before
  /// the first frame is left out.
  std::vector<LidarScan> scansOf(const RgbdRenderer& renderer, std::size_t index) const;

 private:
  std::int64_t endOf(std::int64_t turn) const;

  LidarSensorConfig config_;
  std::vector<TimedPose> true_poses_;  ///< of the body
  std::vector<TimedPose> reported_poses_;
  std::uint64_t seed_;
};

/// T_body_camera where the camera is mounted over the origin of the body and looks ahead.
Transform cameraOnBody(double height_m, double pitch_down_deg);

}  // namespace hydrabench

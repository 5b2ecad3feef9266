// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "core/config/config_reader.h"
#include "core/geometry/raycaster.h"
#include "eval/datasets/dataset.h"
#include "eval/simulation/scene.h"

namespace hydrabench {

struct TrajectoryConfig {
  double duration_s = 200;
  double rate_hz = 10;
  double camera_height_m = 0.8;
  double camera_pitch_deg = 8;  ///< downwards
  double robot_radius_m = 0.25;
  double max_speed_m_s = 1.0;
  double max_acceleration_m_s2 = 0.5;  ///< along the way and across it
  double max_yaw_rate_deg_s = 60;

  std::size_t numFrames() const;
};
void read(ConfigReader& reader, TrajectoryConfig& config);

/// Drives a robot through every room of a scene. Position and heading are independent, as for a
/// camera on a pan unit: the robot follows a smooth tour and looks where there is most to see.
/// Exactly numFrames() poses from stamp 0 on. Throws InputError where the robot does not fit
/// through or the time is too short.
/// @param world  the scene's surfaces; mesh i < objects.size() is object i
std::vector<StampedPose> makeTrajectory(const Scene& scene, const Raycaster& world,
                                        const Camera& camera, const TrajectoryConfig& config);

/// Pose of a camera (x right, y down, z forward) on the floor plan.
Transform cameraPose(const Eigen::Vector2d& place, double height_m, double yaw_rad,
                     double pitch_down_rad);

}  // namespace hydrabench

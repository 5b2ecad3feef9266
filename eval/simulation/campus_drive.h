// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "core/geometry/raycaster.h"
#include "eval/simulation/campus_world.h"
#include "eval/simulation/trajectory.h"

namespace hydrabench {

/// The robot on four wheels at a place: origin on the ground, x ahead, z up, leaning as the ground
/// below its wheels does (0.5 m apart).
Transform robotPose(const CampusTerrain& terrain, const Eigen::Vector2d& place, double yaw_rad);

/// Drives the robot along its way, once, in the time that the config gives, at rest at both ends.
/// The camera is fixed to the body but for a slow pan: it looks ahead and turns to the objects on
/// either side. Exactly numFrames() poses from stamp 0 on. Throws InputError where the time is too
/// short.
/// @param world  the scene's surfaces; mesh i < objects.size() is object i
std::vector<StampedPose> driveThroughCampus(const Scene& scene, const CampusTerrain& terrain,
                                            const CampusWay& way, const Raycaster& world,
                                            const Camera& camera, const TrajectoryConfig& config);

}  // namespace hydrabench

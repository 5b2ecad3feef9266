// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "eval/simulation/campus_world.h"

namespace hydrabench {

/// Cars in bays along the kerbs, hydrants behind them, benches at the back of the pavements, and
/// street furniture and trees, along the way. Nothing touches anything else or stands on the way.
/// Cars lean with the road; everything else stands upright, benches where it is level. Three
/// quarters of the scored ones stand on the side of the way, the others across the road.
std::vector<PlacedShape> placeCampusObjects(const CampusConfig& config,
                                            const CampusTerrain& terrain, const CampusWay& way,
                                            std::uint64_t seed);

/// One of the outdoor families of a class, each as likely.
const ShapeFamily& drawOutdoorFamily(const std::string& class_name, Random& random);

/// Pose of a car on four wheels: height and slope from the ground below them.
/// @param box  around the car, object frame
Transform wheeledPose(const CampusTerrain& terrain, const Eigen::Vector2d& place, double yaw_rad,
                      const Aabb& box);

}  // namespace hydrabench

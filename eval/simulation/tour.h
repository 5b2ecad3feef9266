// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "eval/simulation/clearance_map.h"
#include "eval/simulation/visibility.h"

namespace hydrabench {

/// What a camera at a fixed height and pitch can see of the targets, whatever its heading.
struct SightModel {
  const Raycaster& world;
  const SurfaceTargets& targets;
  double height_m = 0.8;
  double pitch_rad = 0;            ///< downwards positive
  double half_vertical_rad = 0.5;  ///< half the vertical field of view
  double min_range_m = 0.4;
  double max_range_m = 3.5;

  /// Indices of the targets in view from a place on the floor, ascending.
  std::vector<std::uint32_t> visibleFrom(const Eigen::Vector2d& place) const;
};

/// A closed-form description of where to go: a smooth curve on the floor through places from which
/// all objects can be seen.
struct Tour {
  std::vector<Eigen::Vector2d> points;  ///< at most 3 cm apart
  double length_m = 0;
};

/// Plans a tour that enters every room and then takes in the stops that show most of what was not
/// seen yet per metre of detour, until `length_budget_m` is used up. Clearance stays at or above
/// `robot_radius_m` everywhere. Throws InputError where a room cannot be entered.
Tour planTour(const Scene& scene, const ClearanceMap& map, const SightModel& sight,
              double robot_radius_m, double length_budget_m);

}  // namespace hydrabench

// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include <Eigen/Core>

namespace hydrabench {

/// One moment of a tour: where to look to see what.
struct GazeMoment {
  double heading_rad = 0;              ///< direction of travel
  std::vector<float> bearings_rad;     ///< of everything visible from here
  std::vector<std::uint32_t> targets;  ///< which they are; same size
};

struct GazeLimits {
  double half_view_rad = 0.6;  ///< what counts as seen to either side of the gaze
  double max_turn_rad = 0.5;   ///< between two moments
};

/// Yaw of the camera at every moment: sees each of `num_targets` targets as often as possible, the
/// first times counting most, and prefers to look ahead. Best sequence over overlapping windows by
/// dynamic programming. Unwrapped: neighbours differ by at most max_turn_rad.
std::vector<double> planGaze(const std::vector<GazeMoment>& moments,
                             const std::vector<std::size_t>& object_of_target,
                             const GazeLimits& limits);

}  // namespace hydrabench

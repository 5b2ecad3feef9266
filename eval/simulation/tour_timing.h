// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include <Eigen/Core>

#include "eval/simulation/tour.h"
#include "eval/simulation/trajectory.h"

namespace hydrabench {

inline constexpr double kMomentSpacing_s = 0.5;  ///< gaze is planned this densely

/// Arrival time [s] at every point of the tour for a top speed [m/s]: slow in bends, bounded
/// acceleration, at rest at both ends.
std::vector<double> arrivalTimes(const Tour& tour, const TrajectoryConfig& config,
                                 double top_speed);

/// Arrival times for the top speed at which the tour takes exactly the time there is [s].
std::vector<double> timesFor(const Tour& tour, const TrajectoryConfig& config, double duration);

/// Where on the tour one is at 0, spacing, 2 spacing ...; stays at the end once it is reached.
std::vector<Eigen::Vector2d> placesAt(const Tour& tour, const std::vector<double>& times,
                                      double spacing_s, std::size_t count);

/// Weighted mean over a window that is cut at the ends: no rate exceeds the largest one in the
/// input.
/// @param sigma  of the Gaussian weights, in values
std::vector<double> smoothed(const std::vector<double>& values, double sigma);

/// From one yaw a moment (kMomentSpacing_s) to one a frame, smoothed [rad].
std::vector<double> yawAtFrames(const std::vector<double>& yaw, const TrajectoryConfig& config);

}  // namespace hydrabench

// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "core/types/lidar_scan.h"

namespace hydrabench {

/// The points of a scan in the frame that the sensor has at stamp_ns, the motion between start_ns
/// and stamp_ns taken to be steady; points without a return as they are. Times are rounded to a
/// thousandth of the sweep: 0.05 mm at 1 m/s and 10 Hz.
std::vector<Eigen::Vector3f> deskewed(const LidarScan& scan);

/// Rotated, not moved, so that the world's z axis points up: what ground segmenters ask for.
/// @param points  in the frame of T_world_points
std::vector<Eigen::Vector3f> levelled(const std::vector<Eigen::Vector3f>& points,
                                      const Transform& T_world_points);

}  // namespace hydrabench

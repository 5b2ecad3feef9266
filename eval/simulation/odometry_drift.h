// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "core/config/config_reader.h"
#include "eval/datasets/dataset.h"

namespace hydrabench {

/// Error of dead reckoning: a smooth random walk of yaw and position, by distance travelled. Roll
/// and pitch do not drift, because gravity is measured. Off by default, as the uHumans2 evaluations
/// use true poses.
struct OdometryDriftConfig {
  double translation_m_per_sqrt_m =
      0;  ///< deviation per axis after 1 m; grows with the root of the distance
  double yaw_deg_per_sqrt_m = 0;
  double smoothness_m = 1.0;  ///< the rate of drift changes over this distance
};
void read(ConfigReader& reader, OdometryDriftConfig& config);

/// The poses odometry would report. The first pose is exact.
std::vector<Transform> driftedPoses(const std::vector<StampedPose>& trajectory,
                                    const OdometryDriftConfig& config, std::uint64_t seed);

}  // namespace hydrabench

// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "core/geometry/pose_interpolation.h"

#include <algorithm>

namespace hydrabench {

std::optional<Transform> poseAt(std::span<const TimedPose> poses, std::int64_t stamp_ns) {
  const auto after = std::lower_bound(
      poses.begin(), poses.end(), stamp_ns,
      [](const TimedPose& pose, std::int64_t stamp) { return pose.stamp_ns < stamp; });
  if (after == poses.end()) return std::nullopt;
  if (after->stamp_ns == stamp_ns) return after->T_world_body;
  if (after == poses.begin()) return std::nullopt;
  const TimedPose& before = *(after - 1);
  // Differences of stamps fit into a double; stamps since 1970 do not.
  const double fraction = static_cast<double>(stamp_ns - before.stamp_ns) /
                          static_cast<double>(after->stamp_ns - before.stamp_ns);
  return interpolate(before.T_world_body, after->T_world_body, fraction);
}

}  // namespace hydrabench

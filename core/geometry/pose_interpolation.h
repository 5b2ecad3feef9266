// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "core/geometry/transform.h"

namespace hydrabench {

/// Where a moving body was at one instant.
struct TimedPose {
  std::int64_t stamp_ns = 0;
  Transform T_world_body = Transform::Identity();
};

/// Pose at any time between the given ones: linear in translation, spherical-linear in rotation; at
/// a given stamp that very pose, to the bit. nullopt before the first and after the last, because a
/// guess there would be an extrapolation.
/// @param poses  stamps strictly ascending
std::optional<Transform> poseAt(std::span<const TimedPose> poses, std::int64_t stamp_ns);

}  // namespace hydrabench

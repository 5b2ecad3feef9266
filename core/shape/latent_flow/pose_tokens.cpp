// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "core/shape/latent_flow/pose_tokens.h"

#include <algorithm>
#include <cmath>

namespace hydrabench {
namespace {

/// Brings the numbers to about the same spread; found on training views.
constexpr double kPlaceGain = 2;
constexpr double kScaleGain = 2;
constexpr double kLargestLog = 3;

}  // namespace

PoseTokens toPoseTokens(const LocalFrame& object, const LocalFrame& view) {
  const Eigen::Vector3d place = kPlaceGain * view.toLocal(object.center);
  const double yaw = object.bearing - view.bearing;
  PoseTokens tokens;
  tokens.numbers = {static_cast<float>(std::cos(yaw)),
                    static_cast<float>(std::sin(yaw)),
                    0,
                    static_cast<float>(place.x()),
                    static_cast<float>(place.y()),
                    static_cast<float>(place.z()),
                    static_cast<float>(kScaleGain * std::log(object.scale / view.scale)),
                    0,
                    0};
  return tokens;
}

LocalFrame fromPoseTokens(const PoseTokens& tokens, const LocalFrame& view) {
  const auto& n = tokens.numbers;
  LocalFrame object;
  object.bearing = view.bearing + std::atan2(n[1], n[0]);
  object.center = view.toLevel(Eigen::Vector3d(n[3], n[4], n[5]) / kPlaceGain);
  object.scale = view.scale * std::exp(std::clamp(n[6] / kScaleGain, -kLargestLog, kLargestLog));
  return object;
}

}  // namespace hydrabench

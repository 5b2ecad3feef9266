// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Geometry>

#include "core/geometry/transform.h"

namespace hydrabench {

/// Pose of something that stands at a place of sloping ground and leans with it: z along the
/// normal, x uphill or downhill in the direction of `yaw_rad`.
/// @param slope  rise per metre along world x and y
inline Transform leaningPose(const Eigen::Vector3d& place, double yaw_rad,
                             const Eigen::Vector2d& slope) {
  const Eigen::Vector2d ahead(std::cos(yaw_rad), std::sin(yaw_rad));
  const Eigen::Vector3d z = Eigen::Vector3d(-slope.x(), -slope.y(), 1).normalized();
  const Eigen::Vector3d x = Eigen::Vector3d(ahead.x(), ahead.y(), slope.dot(ahead)).normalized();
  Transform pose = Transform::Identity();
  pose.linear().col(0) = x;
  pose.linear().col(1) = z.cross(x);
  pose.linear().col(2) = z;
  pose.translation() = place;
  return pose;
}

}  // namespace hydrabench

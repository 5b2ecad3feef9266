// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include <Eigen/Core>

#include "core/geometry/transform.h"
#include "core/lidar/camera_points.h"
#include "core/types/frame.h"

namespace hydrabench {

/// Gives lidar points the classes of the pixels they are seen in: kUnknownLabel for points out of
/// view, hidden, or farther than the margin of the occlusion test from what the camera's own depth
/// says, where it says something. Without a label image, all are unknown.
/// @param points  in the frame of T_world_points
std::vector<Label> labelsFromImage(const Frame& frame, std::span<const Eigen::Vector3f> points,
                                   const Transform& T_world_points, const OcclusionConfig& config);

}  // namespace hydrabench

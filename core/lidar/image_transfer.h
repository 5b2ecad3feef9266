// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "core/geometry/transform.h"
#include "core/lidar/camera_points.h"
#include "core/types/frame.h"

namespace hydrabench {

/// What an image says of lidar points; one entry per point.
struct PointLooks {
  std::vector<Label> labels;  ///< kUnknownLabel where nothing is known
  std::vector<Rgb> colors;
  std::vector<std::uint8_t> uncolored;  ///< 1 where no colour is known
};

/// Gives lidar points the class and the colour of the pixels they are seen in. Nothing is known of
/// points out of view, hidden, or farther than the margin of the occlusion test from what the
/// camera's own depth says, where it says something; nor where the frame lacks the image.
/// @param points  in the frame of T_world_points
PointLooks looksFromImage(const Frame& frame, std::span<const Eigen::Vector3f> points,
                          const Transform& T_world_points, const OcclusionConfig& config);

}  // namespace hydrabench

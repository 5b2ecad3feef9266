// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "core/lidar/image_transfer.h"

#include <cmath>

namespace hydrabench {

PointLooks looksFromImage(const Frame& frame, std::span<const Eigen::Vector3f> points,
                          const Transform& T_world_points, const OcclusionConfig& config) {
  PointLooks looks{std::vector<Label>(points.size(), kUnknownLabel),
                   std::vector<Rgb>(points.size()), std::vector<std::uint8_t>(points.size(), 1)};
  if (frame.labels.empty() && frame.color.empty()) return looks;
  const Transform T_camera_points = frame.T_world_camera.inverse() * T_world_points;
  for (const CameraPoint& seen : visiblePoints(points, T_camera_points, frame.camera, config)) {
    const float depth = frame.depth.empty() ? 0.0f : frame.depth.data()[seen.pixel];
    const double margin = config.margin_m + config.margin_share * seen.depth;
    if (depth > 0.0f && std::abs(depth - seen.depth) > margin) continue;
    if (!frame.labels.empty()) looks.labels[seen.point] = frame.labels.data()[seen.pixel];
    if (frame.color.empty()) continue;
    looks.colors[seen.point] = frame.color.data()[seen.pixel];
    looks.uncolored[seen.point] = 0;
  }
  return looks;
}

}  // namespace hydrabench

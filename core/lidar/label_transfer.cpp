// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "core/lidar/label_transfer.h"

#include <cmath>

namespace hydrabench {

std::vector<Label> labelsFromImage(const Frame& frame, std::span<const Eigen::Vector3f> points,
                                   const Transform& T_world_points, const OcclusionConfig& config) {
  std::vector<Label> labels(points.size(), kUnknownLabel);
  if (frame.labels.empty()) return labels;
  const Transform T_camera_points = frame.T_world_camera.inverse() * T_world_points;
  for (const CameraPoint& seen : visiblePoints(points, T_camera_points, frame.camera, config)) {
    const float depth = frame.depth.empty() ? 0.0f : frame.depth.data()[seen.pixel];
    const double margin = config.margin_m + config.margin_share * seen.depth;
    if (depth > 0.0f && std::abs(depth - seen.depth) > margin) continue;
    labels[seen.point] = frame.labels.data()[seen.pixel];
  }
  return labels;
}

}  // namespace hydrabench

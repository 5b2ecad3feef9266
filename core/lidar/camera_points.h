// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "core/config/config_reader.h"
#include "core/geometry/camera.h"
#include "core/geometry/transform.h"

namespace hydrabench {

/// A lidar point that the camera sees.
struct CameraPoint {
  std::uint32_t point = 0;  ///< its number among the points that were given
  std::uint32_t pixel = 0;  ///< row-major index of the nearest pixel
  float depth = 0;          ///< z-depth [m]
};

/// A lidar sits elsewhere than the camera, and sees past things that hide what is behind them from
/// the camera: its points fall into the pixels of what hides them. Such points are found by their
/// neighbours. Only those beside and above count, because the ground comes nearer downwards and
/// hides nothing of itself.
struct OcclusionConfig {
  /// A point is hidden where another one nearby in the image is nearer by more than
  /// margin_m + margin_share * depth.
  double margin_m = 0.2;
  double margin_share = 0.05;
  /// "Nearby": in the same or a neighbouring strip of so many columns, in the same row of pixels or
  /// up to above_px higher.
  int strip_px = 12;
  int above_px = 8;
};
void read(ConfigReader& reader, OcclusionConfig& config);

/// The points in view that nothing hides, in their order; points without a return are passed over.
/// @param points  in a frame of their own, all at one instant
std::vector<CameraPoint> visiblePoints(std::span<const Eigen::Vector3f> points,
                                       const Transform& T_camera_points, const Camera& camera,
                                       const OcclusionConfig& config);

}  // namespace hydrabench

// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include <Eigen/Core>

namespace hydrabench {

/// Pinhole camera without distortion: x right, y down, z forward. Integer (u, v) is the centre of a
/// pixel.
struct Camera {
  int width = 0;   ///< [px]
  int height = 0;  ///< [px]
  double fx = 0;   ///< [px]
  double fy = 0;
  double cx = 0;
  double cy = 0;

  /// Pixel of a point in the camera frame; nullopt behind the camera. May lie outside the image.
  std::optional<Eigen::Vector2d> project(const Eigen::Vector3d& point_camera) const {
    if (!(point_camera.z() > 0)) return std::nullopt;
    return Eigen::Vector2d(fx * point_camera.x() / point_camera.z() + cx,
                           fy * point_camera.y() / point_camera.z() + cy);
  }
  /// Point in the camera frame at z-depth `depth_m` [m] (not range along the ray).
  Eigen::Vector3d backproject(double u, double v, double depth_m) const {
    return {(u - cx) / fx * depth_m, (v - cy) / fy * depth_m, depth_m};
  }
  /// True where the nearest pixel exists.
  bool sees(const Eigen::Vector2d& pixel) const {
    return pixel.x() >= -0.5 && pixel.y() >= -0.5 && pixel.x() < width - 0.5 &&
           pixel.y() < height - 0.5;
  }
  friend bool operator==(const Camera&, const Camera&) = default;
};

}  // namespace hydrabench

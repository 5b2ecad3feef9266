// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <Eigen/Core>

#include "core/geometry/lidar_model.h"
#include "core/mapping/footprint.h"

namespace hydrabench {

/// The angle of (x, y) in [-pi, pi] to 1e-6 rad, a hundredth of what float leaves of a column
/// (Abramowitz and Stegun 4.4.49): several times faster than the library's, and the same bits
/// everywhere.
inline float fastAtan2(float y, float x) {
  constexpr float kPi = std::numbers::pi_v<float>;
  const float ax = std::abs(x);
  const float ay = std::abs(y);
  const float larger = std::max(ax, ay);
  if (larger == 0.0f) return 0.0f;
  const float t = std::min(ax, ay) / larger;
  const float s = t * t;
  float angle = 0.0028662257f;
  for (const float a : {-0.0161657367f, 0.0429096138f, -0.0752896400f, 0.1065626393f,
                        -0.1420889944f, 0.1999355085f, -0.3333314528f, 1.0f}) {
    angle = angle * s + a;
  }
  angle *= t;
  if (ay > ax) angle = kPi / 2 - angle;
  if (x < 0.0f) angle = kPi - angle;
  return y < 0.0f ? -angle : angle;
}

/// PinholeProjection for a spinning LiDAR. The range image has one column more than the sensor: the
/// first one once more, so that interpolation goes across the seam at the back.
class LidarProjection {
 public:
  explicit LidarProjection(const LidarModel& lidar)
      : columns_(static_cast<float>(lidar.columns)),
        columns_per_radian_(static_cast<float>(lidar.columnsPerRadian())),
        rows_per_radian_(static_cast<float>(lidar.rowsPerRadian())),
        top_(static_cast<float>(lidar.top_rad)),
        v_end_(static_cast<float>(lidar.rows) - 0.5f),
        v_max_(lidar.rows - 1) {}

  bool project(const Eigen::Vector3f& p, float& u, float& v) const {
    const float flat = std::sqrt(p.x() * p.x() + p.y() * p.y());
    v = (top_ - fastAtan2(p.z(), flat)) * rows_per_radian_;
    if (!(v >= -0.5f && v < v_end_)) return false;
    u = (std::numbers::pi_v<float> - fastAtan2(p.y(), p.x())) * columns_per_radian_;
    u = std::clamp(u, 0.0f, columns_);
    return true;
  }

  /// Rays per solid angle at the horizon. (Hydra takes a virtual focal length of 45 degrees' worth
  /// of pixels in either direction, which gives a constant share of this.)
  float focalArea() const { return columns_per_radian_ * rows_per_radian_; }
  float inverseDepth(const Eigen::Vector3f& p) const { return 1.0f / p.norm(); }

  /// Of the ball around the body: somewhat too large, never too small.
  Footprint footprint(const std::array<Eigen::Vector3d, 8>& corners) const {
    Footprint f;
    f.pixels = {0, 0, static_cast<int>(columns_), v_max_};
    Eigen::Vector3d center = Eigen::Vector3d::Zero();
    for (const Eigen::Vector3d& p : corners) center += p / 8;
    const double radius = (corners[0] - center).norm();
    const double distance = center.norm();
    if (distance < 1.01 * radius) return f;  // the sensor is in it, or next to it

    const double half = std::asin(radius / distance);
    const double elevation = std::asin(center.z() / distance);
    const double low_v = (top_ - (elevation + half)) * rows_per_radian_;
    const double high_v = (top_ - (elevation - half)) * rows_per_radian_;
    f.outside = low_v > v_end_ + kMargin || high_v < -0.5 - kMargin;
    if (f.outside) return f;
    f.inside = low_v > kMargin - 0.5 && high_v < v_end_ - kMargin;
    // One pixel more on every side: the neighbours of the outermost.
    f.pixels.v0 = std::clamp(static_cast<int>(low_v - 1.0 - kMargin), 0, v_max_);
    f.pixels.v1 = std::clamp(static_cast<int>(std::max(high_v, 0.0) + 1.0 + kMargin), 0, v_max_);

    const double sine = std::sin(half) / std::cos(elevation);
    if (!(sine < 1.0)) return f;  // straight above or below: all around
    const double half_u = std::asin(sine) * columns_per_radian_;
    const double u = (std::numbers::pi - std::atan2(center.y(), center.x())) * columns_per_radian_;
    const double low_u = u - half_u - 1.0 - kMargin;
    const double high_u = u + half_u + 1.0 + kMargin;
    if (low_u < 0 || high_u > columns_) return f;  // across the seam
    f.pixels.u0 = static_cast<int>(low_u);
    f.pixels.u1 = static_cast<int>(high_u);
    return f;
  }

 private:
  static constexpr double kMargin = 0.01;  ///< [px] above the rounding of project()
  float columns_;
  float columns_per_radian_;
  float rows_per_radian_;
  float top_;
  float v_end_;
  int v_max_;
};

}  // namespace hydrabench

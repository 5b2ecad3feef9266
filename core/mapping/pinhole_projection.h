// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <limits>

#include <Eigen/Core>

#include "core/geometry/camera.h"
#include "core/mapping/footprint.h"

namespace hydrabench {

/// How the TSDF integrator looks from a point of the sensor frame into a range image; see also
/// LidarProjection. Only core/mapping/tsdf_integrator.cpp includes this.
class PinholeProjection {
 public:
  explicit PinholeProjection(const Camera& camera)
      : fx_(static_cast<float>(camera.fx)),
        fy_(static_cast<float>(camera.fy)),
        cx_(static_cast<float>(camera.cx)),
        cy_(static_cast<float>(camera.cy)),
        u_end_(static_cast<float>(camera.width) - 0.5f),
        v_end_(static_cast<float>(camera.height) - 0.5f),
        u_max_(camera.width - 1),
        v_max_(camera.height - 1) {}

  /// False where no pixel sees the point.
  bool project(const Eigen::Vector3f& p, float& u, float& v) const {
    if (!(p.z() > 0.0f)) return false;
    const float inverse_z = 1.0f / p.z();
    u = fx_ * p.x() * inverse_z + cx_;
    v = fy_ * p.y() * inverse_z + cy_;
    return u >= -0.5f && u < u_end_ && v >= -0.5f && v < v_end_;
  }

  /// Rays per solid angle at the image centre: rays through a square of side s at depth d are
  /// focalArea() * (s / d)^2.
  float focalArea() const { return fx_ * fy_; }
  float inverseDepth(const Eigen::Vector3f& p) const { return 1.0f / p.z(); }

  Footprint footprint(const std::array<Eigen::Vector3d, 8>& corners) const {
    constexpr double kNear = 1e-3;  // [m] so near to the camera's plane nothing is decided early
    Footprint f;
    double nearest = std::numeric_limits<double>::infinity();
    double farthest = -nearest;
    for (const Eigen::Vector3d& p : corners) {
      nearest = std::min(nearest, p.z());
      farthest = std::max(farthest, p.z());
    }
    f.outside = farthest < -kNear || beyondOneSide(corners);
    f.pixels = {0, 0, u_max_, v_max_};
    if (f.outside || nearest < kNear) return f;

    Eigen::Array2d low = Eigen::Array2d::Constant(std::numeric_limits<double>::infinity());
    Eigen::Array2d high = -low;
    for (const Eigen::Vector3d& p : corners) {
      const Eigen::Array2d pixel(fx_ * p.x() / p.z() + cx_, fy_ * p.y() / p.z() + cy_);
      low = low.min(pixel);
      high = high.max(pixel);
    }
    f.inside = low.x() > kMargin - 0.5 && low.y() > kMargin - 0.5 && high.x() < u_end_ - kMargin &&
               high.y() < v_end_ - kMargin;
    // One pixel more than the hull on every side: the neighbours of the outermost.
    const auto clamped = [](double x, int max) {
      return static_cast<int>(std::clamp(x, 0.0, static_cast<double>(max)));
    };
    f.pixels = {clamped(low.x() - 1.0 - kMargin, u_max_), clamped(low.y() - 1.0 - kMargin, v_max_),
                clamped(high.x() + 1.0 + kMargin, u_max_),
                clamped(high.y() + 1.0 + kMargin, v_max_)};
    return f;
  }

 private:
  static constexpr double kMargin = 0.01;  ///< [px] above the rounding of project()

  /// All corners beyond the same side of the image.
  bool beyondOneSide(const std::array<Eigen::Vector3d, 8>& corners) const {
    bool left = true, right = true, above = true, below = true;
    for (const Eigen::Vector3d& p : corners) {
      left = left && fx_ * p.x() < (-0.5 - kMargin - cx_) * p.z();
      right = right && fx_ * p.x() > (u_end_ + kMargin - cx_) * p.z();
      above = above && fy_ * p.y() < (-0.5 - kMargin - cy_) * p.z();
      below = below && fy_ * p.y() > (v_end_ + kMargin - cy_) * p.z();
    }
    return left || right || above || below;
  }

  float fx_, fy_, cx_, cy_;
  float u_end_, v_end_;
  int u_max_, v_max_;
};

}  // namespace hydrabench

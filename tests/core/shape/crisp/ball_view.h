// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>

#include "core/shape/shape_estimator.h"

namespace hydrabench {

/// A ball of radius 0.3 m, 2 m in front of a camera that looks 0.3 rad down.
constexpr double kBallRadius = 0.3;
inline const Eigen::Vector3d kBallCenter(0.1, 0.05, 2);

inline ShapeObservation viewOfABall() {
  ShapeObservation view;
  view.camera = {.width = 80, .height = 60, .fx = 80, .fy = 80, .cx = 39.5, .cy = 29.5};
  view.T_world_camera.linear() =
      (Eigen::AngleAxisd(-std::numbers::pi / 2 - 0.3, Eigen::Vector3d::UnitX())).toRotationMatrix();
  view.color = Image<Rgb>(80, 60, Rgb{90, 120, 150});
  view.depth = Image<float>(80, 60, 4);
  view.mask = Image<std::uint8_t>(80, 60, 0);
  for (int v = 0; v < 60; ++v) {
    for (int u = 0; u < 80; ++u) {
      const Eigen::Vector3d ray = view.camera.backproject(u, v, 1);
      const double b = ray.dot(kBallCenter);
      const double root =
          b * b - ray.squaredNorm() * (kBallCenter.squaredNorm() - kBallRadius * kBallRadius);
      if (root < 0) continue;
      view.depth(u, v) = static_cast<float>((b - std::sqrt(root)) / ray.squaredNorm());
      view.mask(u, v) = 1;
    }
  }
  return view;
}

}  // namespace hydrabench

// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "core/lidar/camera_points.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/mapping/ground/ground_scan.h"
#include "core/types/image.h"

namespace hydrabench {
namespace {

std::vector<CameraPoint> projected(std::span<const Eigen::Vector3f> points,
                                   const Transform& T_camera_points, const Camera& camera) {
  const Eigen::Affine3f T(T_camera_points.cast<float>());
  std::vector<CameraPoint> seen;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!isMeasured(points[i])) continue;
    const Eigen::Vector3f p = T * points[i];
    if (!(p.z() > 0.0f)) continue;
    const double u = camera.fx * p.x() / p.z() + camera.cx;
    const double v = camera.fy * p.y() / p.z() + camera.cy;
    if (!camera.sees({u, v})) continue;
    const auto column = static_cast<std::uint32_t>(u + 0.5);
    const auto row = static_cast<std::uint32_t>(v + 0.5);
    seen.push_back({static_cast<std::uint32_t>(i),
                    row * static_cast<std::uint32_t>(camera.width) + column, p.z()});
  }
  return seen;
}

/// Smallest depth of the points nearby, as OcclusionConfig has it, per strip and row; infinite
/// where there are none.
Image<float> nearestAround(const std::vector<CameraPoint>& points, const Camera& camera,
                           const OcclusionConfig& config) {
  const Image<float> none((camera.width + config.strip_px - 1) / config.strip_px, camera.height,
                          std::numeric_limits<float>::infinity());
  Image<float> own = none;
  for (const CameraPoint& p : points) {
    const int u = static_cast<int>(p.pixel) % camera.width;
    const int v = static_cast<int>(p.pixel) / camera.width;
    float& nearest = own(u / config.strip_px, v);
    nearest = std::min(nearest, p.depth);
  }
  Image<float> beside = none;
  Image<float> around = none;
  for (int v = 0; v < own.height(); ++v) {
    for (int u = 0; u < own.width(); ++u) {
      for (int near = std::max(0, u - 1); near <= std::min(own.width() - 1, u + 1); ++near) {
        beside(u, v) = std::min(beside(u, v), own(near, v));
      }
      for (int above = std::max(0, v - config.above_px); above <= v; ++above) {
        around(u, v) = std::min(around(u, v), beside(u, above));
      }
    }
  }
  return around;
}

}  // namespace

std::vector<CameraPoint> visiblePoints(std::span<const Eigen::Vector3f> points,
                                       const Transform& T_camera_points, const Camera& camera,
                                       const OcclusionConfig& config) {
  std::vector<CameraPoint> seen = projected(points, T_camera_points, camera);
  const Image<float> nearest = nearestAround(seen, camera, config);
  std::erase_if(seen, [&](const CameraPoint& p) {
    const int u = static_cast<int>(p.pixel) % camera.width;
    const int v = static_cast<int>(p.pixel) / camera.width;
    const double margin = config.margin_m + config.margin_share * p.depth;
    return p.depth > nearest(u / config.strip_px, v) + margin;
  });
  return seen;
}

void read(ConfigReader& reader, OcclusionConfig& config) {
  reader.field("margin_m", config.margin_m, Bounds{0, 100});
  reader.field("margin_share", config.margin_share, Bounds{0, 1});
  reader.field("strip_px", config.strip_px, Bounds{1, 1000});
  reader.field("above_px", config.above_px, Bounds{0, 1000});
}

}  // namespace hydrabench

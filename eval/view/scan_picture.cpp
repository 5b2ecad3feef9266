// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/view/scan_picture.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/geometry/transform.h"
#include "eval/view/frame_picture.h"

namespace hydrabench {
namespace {

constexpr int kSide = 900;          // pixels, of the picture from above
constexpr int kBandHeight = 192;    // about, of the one below
constexpr double kLowest_m = -2.5;  // under the sensor: blue
constexpr double kHighest_m = 2.5;  // red

bool measured(const Eigen::Vector3f& point) { return point.allFinite() && !point.isZero(); }

/// The highest point of every pixel.
Image<Rgb> fromAbove(const LidarScan& scan, double radius_m) {
  const double scale = kSide / (2 * radius_m);
  const Transform T_end_start = scan.T_world_lidar.inverse() * scan.T_world_lidar_start;
  Image<float> depth(kSide, kSide);  // below kHighest_m
  for (std::size_t i = 0; i < scan.points.size(); ++i) {
    if (!measured(scan.points[i])) continue;
    Eigen::Vector3d point = scan.points[i].cast<double>();
    if (!scan.times.empty()) {
      point = interpolate(T_end_start, Transform::Identity(), double{scan.times[i]}) * point;
    }
    const int u = static_cast<int>(std::floor((radius_m - point.y()) * scale));
    const int v = static_cast<int>(std::floor((radius_m - point.x()) * scale));
    if (!depth.contains(u, v)) continue;
    const auto below =
        static_cast<float>(kHighest_m - std::clamp(point.z(), kLowest_m, kHighest_m - 0.01));
    if (depth(u, v) == 0 || below < depth(u, v)) depth(u, v) = below;
  }
  return depthPicture(depth, static_cast<float>(kHighest_m - kLowest_m));
}

/// The nearest point of every pixel.
Image<Rgb> asSeen(const LidarScan& scan, double radius_m) {
  const LidarModel& lidar = scan.lidar;
  const int stretch = std::max(1, kBandHeight / lidar.rows);
  Image<float> range(kSide, lidar.rows * stretch);
  for (std::size_t i = 0; i < scan.points.size(); ++i) {
    const Eigen::Vector3f& point = scan.points[i];
    if (!measured(point)) continue;
    const double azimuth = std::atan2(double{point.y()}, double{point.x()});
    const double elevation = std::asin(double{point.z()} / double{point.norm()});
    const int u = static_cast<int>(kSide * (0.5 - azimuth / (2 * std::numbers::pi))) % kSide;
    const int row =
        scan.rings.empty()
            ? static_cast<int>(std::lround((lidar.top_rad - elevation) * lidar.rowsPerRadian()))
            : scan.rings[i];
    for (int v = row * stretch; v < (row + 1) * stretch; ++v) {
      if (!range.contains(u, v)) continue;
      if (range(u, v) == 0 || point.norm() < range(u, v)) range(u, v) = point.norm();
    }
  }
  return depthPicture(range, static_cast<float>(radius_m));
}

}  // namespace

Image<Rgb> scanPicture(const LidarScan& scan, double radius_m) {
  const Image<Rgb> above = fromAbove(scan, radius_m);
  const Image<Rgb> seen = asSeen(scan, radius_m);
  constexpr int kGap = 4;
  Image<Rgb> picture(kSide, above.height() + kGap + seen.height(), {255, 255, 255});
  std::copy(above.begin(), above.end(), picture.begin());
  std::copy(seen.begin(), seen.end(), picture.end() - static_cast<std::ptrdiff_t>(seen.size()));
  return picture;
}

}  // namespace hydrabench

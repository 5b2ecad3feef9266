// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "core/lidar/lidar_view.h"

#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>

#include "core/parallel/parallel_for.h"

namespace hydrabench {
namespace {

constexpr std::uint32_t kNoPoint = std::numeric_limits<std::uint32_t>::max();
constexpr std::int32_t kNoPixel = -1;

double rowOf(const LidarModel& lidar, const Eigen::Vector3f& p) {
  return (lidar.top_rad - std::atan2(p.z(), std::hypot(p.x(), p.y()))) * lidar.rowsPerRadian();
}

/// Pixel of a point in an image of the model's rows and columns; kNoPixel beyond its rows.
std::int32_t pixelOf(const LidarModel& lidar, const Eigen::Vector3f& p) {
  const double row = rowOf(lidar, p);
  const double column = (std::numbers::pi - std::atan2(p.y(), p.x())) * lidar.columnsPerRadian();
  const auto v = static_cast<int>(std::floor(row + 0.5));
  if (v < 0 || v >= lidar.rows) return kNoPixel;
  return v * lidar.columns + static_cast<int>(std::floor(column + 0.5)) % lidar.columns;
}

/// Copies what `of` says of every pixel's point, the first column once more at the end.
template <typename Pixel, typename Of>
Image<Pixel> picture(const Image<std::uint32_t>& nearest, const Of& of) {
  Image<Pixel> image(nearest.width() + 1, nearest.height());
  for (int v = 0; v < nearest.height(); ++v) {
    for (int u = 0; u <= nearest.width(); ++u) {
      const std::uint32_t point = nearest(u % nearest.width(), v);
      image(u, v) = point == kNoPoint ? Pixel{} : static_cast<Pixel>(of(point));
    }
  }
  return image;
}

}  // namespace

LidarView::LidarView(const LidarScan& scan, const Points& points, double min_range_m,
                     double max_range_m) {
  const std::size_t count = points.points.size();
  std::vector<std::int32_t> pixels(count, kNoPixel);
  std::vector<float> ranges(count, 0.0f);
  constexpr std::size_t kGrain = 1024;
  parallelFor(
      count,
      [&](std::size_t i) {
        const Eigen::Vector3f& p = points.points[i];
        if (!isMeasured(p)) return;
        ranges[i] = p.norm();
        if (ranges[i] >= static_cast<float>(min_range_m)) pixels[i] = pixelOf(scan.lidar, p);
      },
      kGrain);

  Image<std::uint32_t> nearest(scan.lidar.columns, scan.lidar.rows, kNoPoint);
  for (std::size_t i = 0; i < count; ++i) {
    if (pixels[i] == kNoPixel) continue;
    std::uint32_t& best = nearest.data()[pixels[i]];
    if (best == kNoPoint || ranges[i] < ranges[best]) best = static_cast<std::uint32_t>(i);
  }

  view_.stamp_ns = scan.stamp_ns;
  view_.T_world_sensor = scan.T_world_lidar;
  view_.lidar = scan.lidar;
  view_.min_range_m = min_range_m;
  view_.max_range_m = max_range_m;
  view_.range = picture<float>(nearest, [&](std::uint32_t i) { return ranges[i]; });
  if (!points.labels.empty()) {
    labels_ = picture<Label>(nearest, [&](std::uint32_t i) { return points.labels[i]; });
    view_.labels = &labels_;
  }
  if (!points.colors.empty()) {
    color_ = picture<Rgb>(nearest, [&](std::uint32_t i) { return points.colors[i]; });
    uncolored_ =
        picture<std::uint8_t>(nearest, [&](std::uint32_t i) { return points.uncolored[i]; });
    view_.color = &color_;
    view_.uncolored = &uncolored_;
  }
  if (!points.ground.empty()) {
    ground_ = picture<std::uint8_t>(
        nearest, [&](std::uint32_t i) { return points.ground[i] == GroundClass::kGround; });
    view_.ground = &ground_;
    row_offset_ = picture<float>(nearest, [&](std::uint32_t i) {
      const double row = rowOf(scan.lidar, points.points[i]);
      return row - std::floor(row + 0.5);
    });
    view_.row_offset = &row_offset_;
  }
  if (!points.moving.empty()) {
    mask_ = picture<std::uint8_t>(nearest, [&](std::uint32_t i) { return points.moving[i]; });
    view_.mask = &mask_;
  }
  summarizeRange(view_);
}

}  // namespace hydrabench

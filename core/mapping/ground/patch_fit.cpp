// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "core/mapping/ground/patch_fit.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace hydrabench {
namespace {

/// Plane of the points that lie less than `seed_height_m` above the mean of the lowest ones, or
/// below it.
std::optional<Plane> seedPlane(const std::vector<BinPoint>& points, bool first_zone,
                               double sensor_height_m, double seed_height_m,
                               const PatchFitConfig& config) {
  std::vector<float> heights;
  heights.reserve(points.size());
  const double margin = config.seed_margin * sensor_height_m;
  for (const BinPoint& point : points) {
    const float z = point.position.z();
    if (!first_zone || static_cast<double>(z) >= margin) heights.push_back(z);
  }
  const std::size_t count =
      std::min(heights.size(), static_cast<std::size_t>(config.lowest_points));
  const auto end = heights.begin() + static_cast<std::ptrdiff_t>(count);
  std::partial_sort(heights.begin(), end, heights.end());
  double lowest = 0;  // the height of the sensor, where every point lies below the margin
  for (auto height = heights.begin(); height != end; ++height) lowest += double{*height};
  if (count > 0) lowest /= static_cast<double>(count);

  PlaneMoments seeds;
  for (const BinPoint& point : points) {
    if (static_cast<double>(point.position.z()) < lowest + seed_height_m) seeds.add(point.position);
  }
  return seeds.plane();
}

/// R-VPF: points on planes too steep for ground leave the list. A wall that stands on the ground
/// has its foot among the lowest points; left in, it would tilt the plane of the ground.
void removeVerticals(std::vector<BinPoint>& points, double sensor_height_m,
                     const PatchFitConfig& config) {
  for (int i = 0; i < config.iterations; ++i) {
    const auto plane =
        seedPlane(points, true, sensor_height_m, config.vertical.seed_height_m, config);
    if (!plane || plane->normal.z() >= config.min_uprightness) return;
    std::erase_if(points, [&](const BinPoint& point) {
      return std::abs(plane->signedDistance(point.position)) < config.vertical.thickness_m;
    });
  }
}

}  // namespace

std::optional<Patch> fitPatch(std::vector<BinPoint> points, bool first_zone, double sensor_height_m,
                              const PatchFitConfig& config) {
  if (first_zone && config.vertical.enabled) removeVerticals(points, sensor_height_m, config);
  auto plane = seedPlane(points, first_zone, sensor_height_m, config.seed_height_m, config);
  const auto onPlane = [&](const BinPoint& point) {
    return plane->signedDistance(point.position) < config.thickness_m;
  };
  for (int i = 0; i < config.iterations && plane; ++i) {
    PlaneMoments near;
    for (const BinPoint& point : points) {
      if (onPlane(point)) near.add(point.position);
    }
    // The last plane is that of the points it is told by, which stay those of the plane before.
    if (i + 1 == config.iterations) {
      std::erase_if(points, [&](const BinPoint& point) { return !onPlane(point); });
    }
    plane = near.plane();
  }
  if (!plane) return std::nullopt;
  return Patch{*plane, std::move(points)};
}

void read(ConfigReader& reader, PatchFitConfig& config) {
  reader.field("iterations", config.iterations, Bounds{1, 100});
  reader.field("lowest_points", config.lowest_points, Bounds{1, 1e6});
  reader.field("seed_height_m", config.seed_height_m, Bounds{0, 10});
  reader.field("thickness_m", config.thickness_m, Bounds{0, 10});
  reader.field("seed_margin", config.seed_margin, Bounds{-100, 0});
  reader.field("min_uprightness", config.min_uprightness, Bounds{0, 1});
  auto vertical = reader.section("vertical");
  vertical.field("enabled", config.vertical.enabled);
  vertical.field("seed_height_m", config.vertical.seed_height_m, Bounds{0, 10});
  vertical.field("thickness_m", config.vertical.thickness_m, Bounds{0, 10});
}

}  // namespace hydrabench

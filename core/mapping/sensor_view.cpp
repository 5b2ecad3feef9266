// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "core/mapping/sensor_view.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "core/mapping/frame_check.h"
#include "core/parallel/parallel_for.h"

namespace hydrabench {
namespace {

/// Ranges of one row of pixels; 0 for depths that are missing, not finite or too near.
/// @param xx  square of x/z per column
void rowOfRanges(const float* depth, const float* xx, float yy, float min_range, float* range,
                 int width) {
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  for (int u = 0; u < width; ++u) {
    const float r = depth[u] * std::sqrt(1.0f + xx[u] + yy);
    range[u] = r >= min_range && r < kInfinity ? r : 0.0f;  // false for NaN
  }
}

/// @return  the largest range in the squares of one row of tiles
float rowOfTiles(const Image<float>& range, int tile_v, Image<RangeTiles::Bounds>& bounds) {
  constexpr int kSide = RangeTiles::kSide;
  const int v_end = std::min(range.height(), (tile_v + 1) * kSide);
  float largest = 0;
  for (int tile_u = 0; tile_u < bounds.width(); ++tile_u) {
    const int u_begin = tile_u * kSide;
    const int count = std::min(range.width(), u_begin + kSide) - u_begin;
    RangeTiles::Bounds& tile = bounds(tile_u, tile_v);
    tile.min = range(u_begin, tile_v * kSide);
    for (int v = tile_v * kSide; v < v_end; ++v) {
      const float* row = &range(u_begin, v);
      for (int i = 0; i < count; ++i) {
        tile.min = std::min(tile.min, row[i]);
        tile.max = std::max(tile.max, row[i]);
      }
    }
    largest = std::max(largest, tile.max);
  }
  return largest;
}

/// Rows of tiles in parallel; `prepare` fills rows [begin, end) of view.range first.
template <typename Prepare>
void summarize(SensorView& view, const Prepare& prepare) {
  constexpr int kSide = RangeTiles::kSide;
  const int height = view.range.height();
  const int tiles_high = (height + kSide - 1) / kSide;
  view.tiles.bounds =
      Image<RangeTiles::Bounds>((view.range.width() + kSide - 1) / kSide, tiles_high);
  std::vector<float> largest(static_cast<std::size_t>(tiles_high), 0.0f);
  parallelFor(
      largest.size(),
      [&](std::size_t i) {
        const int tile_v = static_cast<int>(i);
        prepare(tile_v * kSide, std::min(height, (tile_v + 1) * kSide));
        largest[i] = rowOfTiles(view.range, tile_v, view.tiles.bounds);
      },
      4);
  view.max_measured_m = 0;
  for (const float range : largest) view.max_measured_m = std::max(view.max_measured_m, range);
}

template <typename Pixel>
const Image<Pixel>* ifAny(const Image<Pixel>& image) {
  return image.empty() ? nullptr : &image;
}

}  // namespace

RangeTiles::Bounds RangeTiles::over(int u0, int v0, int u1, int v1) const {
  Bounds all = bounds(u0 / kSide, v0 / kSide);
  for (int v = v0 / kSide; v <= v1 / kSide; ++v) {
    for (int u = u0 / kSide; u <= u1 / kSide; ++u) {
      all.min = std::min(all.min, bounds(u, v).min);
      all.max = std::max(all.max, bounds(u, v).max);
    }
  }
  return all;
}

SensorView sensorView(const Frame& frame, double min_range_m, double max_range_m) {
  requireUsable(frame);
  const Camera& camera = frame.camera;
  const Image<float>& depth = frame.depth;
  SensorView view;
  view.stamp_ns = frame.stamp_ns;
  view.T_world_sensor = frame.T_world_camera;
  view.camera = camera;
  view.min_range_m = min_range_m;
  view.max_range_m = max_range_m;
  view.color = ifAny(frame.color);
  view.labels = ifAny(frame.labels);
  view.range = Image<float>(depth.width(), depth.height());

  std::vector<float> xx(static_cast<std::size_t>(depth.width()));
  for (int u = 0; u < depth.width(); ++u) {
    const double x = (u - camera.cx) / camera.fx;
    xx[static_cast<std::size_t>(u)] = static_cast<float>(x * x);
  }
  summarize(view, [&](int begin, int end) {
    for (int v = begin; v < end; ++v) {
      const double y = (v - camera.cy) / camera.fy;
      rowOfRanges(&depth(0, v), xx.data(), static_cast<float>(y * y),
                  static_cast<float>(min_range_m), &view.range(0, v), depth.width());
    }
  });
  return view;
}

void summarizeRange(SensorView& view) {
  summarize(view, [](int, int) {});
}

}  // namespace hydrabench

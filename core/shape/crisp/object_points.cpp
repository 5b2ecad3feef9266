// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "core/shape/crisp/object_points.h"

#include <algorithm>
#include <cmath>

#include "core/types/random.h"

namespace hydrabench {
namespace {

using Pixels = std::vector<std::uint32_t>;

/// The first `count` of a random order; all of them, still shuffled, where there are fewer.
void shuffleFront(Pixels& pixels, std::size_t count, Random random) {
  count = std::min(count, pixels.size());
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t left = pixels.size() - i;
    std::swap(pixels[i], pixels[i + random.index(static_cast<std::uint32_t>(left))]);
  }
  pixels.resize(count);
}

struct Extent {
  int u_low = 1 << 30;
  int v_low = 1 << 30;
  int u_high = -1;
  int v_high = -1;
};

Extent extentOf(const Image<std::uint8_t>& mask) {
  Extent extent;
  for (int v = 0; v < mask.height(); ++v) {
    for (int u = 0; u < mask.width(); ++u) {
      if (!mask(u, v)) continue;
      extent.u_low = std::min(extent.u_low, u);
      extent.u_high = std::max(extent.u_high, u);
      extent.v_low = std::min(extent.v_low, v);
      extent.v_high = std::max(extent.v_high, v);
    }
  }
  return extent;
}

}  // namespace

ObjectPoints gatherObjectPoints(const ShapeObservation& observation,
                                const ObjectPointsLimits& limits, std::uint64_t seed) {
  const Camera& camera = observation.camera;
  const Extent extent = extentOf(observation.mask);
  ObjectPoints result;
  if (extent.u_high < 0) return result;
  result.cut = {extent.u_low <= 1 ? 1.0f : 0.0f, extent.v_low <= 1 ? 1.0f : 0.0f,
                extent.u_high >= camera.width - 2 ? 1.0f : 0.0f,
                extent.v_high >= camera.height - 2 ? 1.0f : 0.0f};
  const int margin_u = std::max(4, (extent.u_high - extent.u_low) / 2);
  const int margin_v = std::max(4, (extent.v_high - extent.v_low) / 2);
  Pixels on;
  Pixels near;
  Pixels elsewhere;
  for (int v = 0; v < camera.height; ++v) {
    for (int u = 0; u < camera.width; ++u) {
      const float depth = observation.depth(u, v);
      if (!std::isfinite(depth) || !(depth > 0)) continue;
      const auto pixel = static_cast<std::uint32_t>(v * camera.width + u);
      if (observation.mask(u, v)) {
        on.push_back(pixel);
        continue;
      }
      elsewhere.push_back(pixel);
      if (u >= extent.u_low - margin_u && u <= extent.u_high + margin_u &&
          v >= extent.v_low - margin_v && v <= extent.v_high + margin_v) {
        near.push_back(pixel);
      }
    }
  }
  const Random random(seed);
  const auto half = static_cast<std::size_t>(limits.context) / 2;
  shuffleFront(on, static_cast<std::size_t>(limits.object), random.fork(1));
  shuffleFront(near, half, random.fork(2));
  shuffleFront(elsewhere, static_cast<std::size_t>(limits.context) - near.size(), random.fork(3));
  const Eigen::Matrix3d R_level_camera = observation.T_world_camera.linear();
  const auto append = [&](const Pixels& pixels, std::vector<Eigen::Vector3f>& points) {
    for (const std::uint32_t pixel : pixels) {
      const int u = static_cast<int>(pixel) % camera.width;
      const int v = static_cast<int>(pixel) / camera.width;
      points.push_back(
          (R_level_camera * camera.backproject(u, v, observation.depth(u, v))).cast<float>());
    }
  };
  append(on, result.object);
  append(near, result.context);
  append(elsewhere, result.context);
  return result;
}

}  // namespace hydrabench

// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "core/mapping/sensor_view.h"
#include "core/types/frame.h"

namespace hydrabench {

/// A camera at the origin of the world whose pixels meet a wall at kCellDepth in the middles of the
/// cells of a 0.1 m grid: pixel (u, v) sees the point (0.1 u + 0.05, 0.1 v + 0.05, 1.05) m, and at
/// twice that depth the double of it.
inline constexpr float kCellDepth = 1.05f;
inline Camera cellCamera() { return {16, 12, 10.5, 10.5, -0.5, -0.5}; }

/// A wall at kCellDepth without labels or instances.
inline Frame cellFrame(std::int64_t stamp_ns = 1) {
  const Camera camera = cellCamera();
  Frame frame;
  frame.stamp_ns = stamp_ns;
  frame.camera = camera;
  frame.depth = Image<float>(camera.width, camera.height, kCellDepth);
  frame.labels = Image<Label>(camera.width, camera.height);
  frame.instances = Image<InstanceId>(camera.width, camera.height);
  return frame;
}

inline SensorView cellView(const Frame& frame) { return sensorView(frame, 0.1, 10); }

inline std::uint32_t pixelAt(int u, int v) { return static_cast<std::uint32_t>(v * 16 + u); }

}  // namespace hydrabench

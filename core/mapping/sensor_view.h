// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "core/geometry/camera.h"
#include "core/geometry/transform.h"
#include "core/types/frame.h"

namespace hydrabench {

/// One measurement as the map sees it: ranges along rays with what is known of each. The images
/// that are pointed to must outlive the view; a null pointer means "none".
struct SensorView {
  std::int64_t stamp_ns = 0;
  Transform T_world_sensor = Transform::Identity();
  Camera camera;
  Image<float> range;  ///< distance along the ray [m]; 0: nothing measured within the limits
  double min_range_m = 0.1;
  double max_range_m = 5;
  float max_measured_m = 0;  ///< largest range in the image: behind it nothing is known
  const Image<Rgb>* color = nullptr;
  const Image<Label>* labels = nullptr;
  /// Pixels other than 0 update no voxel near the surface they see (moving things); what lies in
  /// front of them is carved free all the same.
  const Image<std::uint8_t>* mask = nullptr;
};

/// Ranges from the z-depth of a frame, limited to [min, max]. Points to the frame's colours and
/// labels, empty images excepted.
SensorView sensorView(const RgbdFrame& frame, double min_range_m, double max_range_m);

}  // namespace hydrabench

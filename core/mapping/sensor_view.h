// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>

#include "core/geometry/camera.h"
#include "core/geometry/lidar_model.h"
#include "core/geometry/transform.h"
#include "core/types/frame.h"

namespace hydrabench {

/// Smallest and largest range in every square of kSide x kSide pixels, to decide about many voxels
/// at once.
struct RangeTiles {
  static constexpr int kSide = 8;
  struct Bounds {
    float min = 0;  ///< 0 where a pixel of the square measured nothing
    float max = 0;
  };
  Image<Bounds> bounds;

  bool empty() const { return bounds.empty(); }
  /// Over all squares that touch the pixels from (u0, v0) to (u1, v1), both inclusive.
  Bounds over(int u0, int v0, int u1, int v1) const;
};

/// One measurement as the map sees it: ranges along rays with what is known of each. The images
/// that are pointed to must outlive the view; a null pointer means "none".
struct SensorView {
  std::int64_t stamp_ns = 0;
  Transform T_world_sensor = Transform::Identity();
  /// Of a pinhole camera; of no size where the view is that of a lidar.
  Camera camera;
  /// Then `range` has one column more, its first one once more: see LidarProjection.
  std::optional<LidarModel> lidar;
  /// Distance along the ray [m]; 0: nothing measured, or nearer than min_range_m. May be beyond
  /// max_range_m: then the surface is too far to map, and what lies before it is known to be free.
  Image<float> range;
  /// Of `range`. Empty: the same results, more slowly. Whoever changes `range` sets tiles and
  /// max_measured_m again, see summarizeRange().
  RangeTiles tiles;
  double min_range_m = 0.1;
  double max_range_m = 5;
  float max_measured_m = 0;  ///< largest range in the image: behind it nothing is known
  const Image<Rgb>* color = nullptr;
  const Image<std::uint8_t>* uncolored = nullptr;  ///< pixels other than 0 have no colour
  const Image<Label>* labels = nullptr;
  /// Pixels other than 0 update no voxel near the surface they see (moving things); what lies in
  /// front of them is carved free all the same.
  const Image<std::uint8_t>* mask = nullptr;
  /// Pixels other than 0 see ground: see TsdfIntegrator.
  const Image<std::uint8_t>* ground = nullptr;
  /// Of a lidar: how far below the middle of its row the ray of a pixel points, from -0.5 to 0.5
  /// rows; its lasers are not at equal angles. On the ground 20 m away half a row is 7 cm of
  /// height.
  const Image<float>* row_offset = nullptr;
};

/// Ranges from the z-depth of a frame. Points to the frame's colours and labels, empty images
/// excepted. Throws InputError where the frame is not usable, see requireUsable().
/// @param max_range_m  voxels beyond it are not updated
SensorView sensorView(const Frame& frame, double min_range_m, double max_range_m);

/// Sets view.tiles and view.max_measured_m from view.range.
void summarizeRange(SensorView& view);

}  // namespace hydrabench

// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "core/mapping/sensor_view.h"
#include "core/types/image.h"

namespace hydrabench {

/// World points of the pixels of a view [m].
class PixelPoints {
 public:
  explicit PixelPoints(const SensorView& view);
  /// @param pixel  row-major index of a measured pixel
  Eigen::Vector3d operator()(std::uint32_t pixel) const {
    const std::size_t width = x_.size();
    return at(pixel, pixel % width, pixel / width);
  }
  /// The same where column and row are known.
  Eigen::Vector3d at(std::size_t pixel, std::size_t u, std::size_t v) const {
    const double x = x_[u];
    const double y = y_[v];
    const double depth = range_[pixel] / std::sqrt(x * x + y * y + 1);
    return origin_ + depth * (x * axis_x_ + y * axis_y_ + axis_z_);
  }

 private:
  const float* range_;
  std::vector<double> x_;                              ///< of a column, at depth 1
  std::vector<double> y_;                              ///< of a row
  Eigen::Vector3d origin_, axis_x_, axis_y_, axis_z_;  ///< of the sensor, in the world
};

/// The pixels that may be grouped.
struct PixelSelection {
  const Image<std::int32_t>& values;              ///< H x W: class or instance
  const SensorView& view;                         ///< pixels without a range do not count
  double max_range_m = 0;                         ///< nor do those that are farther
  const Image<std::uint8_t>* moving;              ///< nor those that are not 0 here; may be null
  std::function<std::size_t(std::int32_t)> kind;  ///< of a value, from 1; 0: does not count
};

/// Pixels that belong together; row-major indices, ascending.
struct PixelGroup {
  std::size_t kind = 0;
  std::vector<std::uint32_t> pixels;
};

/// One group per kind. Groups are listed in the order of their first pixels.
std::vector<PixelGroup> groupsByKind(const PixelSelection& selection, std::size_t num_kinds);

inline constexpr std::size_t kMaxConnectedKinds = 1023;

/// Pixels of one kind whose points touch: the points are put into the cells of a grid, and cells of
/// one kind that share a face, an edge or a corner are connected. Listed like groupsByKind.
/// At most kMaxConnectedKinds kinds; a sensor sees no farther than 130 000 cells.
std::vector<PixelGroup> connectedGroups(const PixelSelection& selection, double cell_m);

}  // namespace hydrabench

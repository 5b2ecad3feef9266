// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <span>

#include <Eigen/Core>

#include "core/mapping/ground/ground_scan.h"
#include "core/mapping/sensor_view.h"
#include "core/types/lidar_scan.h"

namespace hydrabench {

/// A scan as an image of ranges for the TSDF integrator. Of the points that fall into one pixel the
/// nearest is taken, the first of equals, with its label and whether it is ground.
class LidarView {
 public:
  struct Points {
    std::span<const Eigen::Vector3f> points;       ///< in the sensor's frame at the scan's stamp
    std::span<const Label> labels = {};            ///< one per point, or none
    std::span<const Rgb> colors = {};              ///< one per point, or none
    std::span<const std::uint8_t> uncolored = {};  ///< not 0: no colour; with colors
    std::span<const GroundClass> ground = {};      ///< one per point, or none
    std::span<const std::uint8_t> moving =
        {};  ///< not 0: keep out of the map; one per point, or none
  };
  LidarView(const LidarScan& scan, const Points& points, double min_range_m, double max_range_m);
  LidarView(const LidarView&) = delete;
  LidarView& operator=(const LidarView&) = delete;

  const SensorView& view() const { return view_; }

 private:
  Image<Label> labels_;
  Image<Rgb> color_;
  Image<std::uint8_t> uncolored_;
  Image<std::uint8_t> ground_;
  Image<std::uint8_t> mask_;
  Image<float> row_offset_;
  SensorView view_;  ///< points to the images
};

}  // namespace hydrabench

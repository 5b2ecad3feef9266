// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "core/geometry/lidar_model.h"

#include <cmath>
#include <numbers>

namespace hydrabench {

double LidarModel::columnsPerRadian() const { return columns / (2 * std::numbers::pi); }

double LidarModel::rowsPerRadian() const { return (rows - 1) / (top_rad - bottom_rad); }

Eigen::Vector3d LidarModel::direction(double u, double v) const {
  const double azimuth = std::numbers::pi - u / columnsPerRadian();
  const double elevation = top_rad - v / rowsPerRadian();
  return {std::cos(elevation) * std::cos(azimuth), std::cos(elevation) * std::sin(azimuth),
          std::sin(elevation)};
}

}  // namespace hydrabench

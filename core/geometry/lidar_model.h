// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

namespace hydrabench {

/// A spinning LiDAR as an image: x forward, y left, z up. Columns go once around, clockwise from
/// straight back, so that straight ahead is the middle column; rows go down at equal angles. A
/// sensor whose rows are not at equal angles leaves some of them empty.
struct LidarModel {
  int columns = 0;        ///< over 360 degrees
  int rows = 0;           ///< at least 2
  double top_rad = 0;     ///< elevation of row 0, up positive
  double bottom_rad = 0;  ///< elevation of the last row, below top_rad

  double columnsPerRadian() const;
  double rowsPerRadian() const;
  /// Direction of length 1 of a place between pixels.
  Eigen::Vector3d direction(double u, double v) const;

  friend bool operator==(const LidarModel&, const LidarModel&) = default;
};

}  // namespace hydrabench

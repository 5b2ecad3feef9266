// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

namespace hydrabench {

/// A closed curve of four straights and four quarter circles around the world's origin, driven
/// counter-clockwise: the middle line of the campus's road. Everything along the road is given by a
/// distance along the curve and an offset across it.
struct CampusLoop {
  double half_x_m = 42;  ///< half the length of the straights along x
  double half_y_m = 18;  ///< and along y
  double radius_m = 10;  ///< of the corners

  /// A point of a curve beside the loop.
  struct Station {
    Eigen::Vector2d point = Eigen::Vector2d::Zero();
    Eigen::Vector2d ahead = Eigen::Vector2d::UnitX();  ///< direction of travel
    Eigen::Vector2d out = -Eigen::Vector2d::UnitY();   ///< away from the inside, to the right
    bool in_bend = false;
  };

  /// Length of the curve at an offset (outwards positive, above -radius_m) [m].
  double lengthAt(double offset_m) const;
  /// The point after `distance_m` along the curve at an offset, from the start of the southern
  /// straight (-half_x_m, y < 0); goes round as often as it takes.
  Station along(double distance_m, double offset_m) const;
  /// Offset of any place: its signed distance from the loop, outwards positive.
  double offsetOf(const Eigen::Vector2d& place) const;
};

}  // namespace hydrabench

// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <vector>

#include <Eigen/Geometry>

namespace hydrabench {

/// Signed distance to a figure in the plane, exact unless said otherwise, negative inside; the
/// cross-section of extrusions and solids of revolution.
class SdfProfile {
 public:
  virtual ~SdfProfile() = default;
  virtual double value(const Eigen::Vector2d& p) const = 0;  ///< [m]
  virtual Eigen::AlignedBox2d bounds() const = 0;
};
using SdfProfilePtr = std::shared_ptr<const SdfProfile>;
using Polyline = std::vector<Eigen::Vector2d>;

SdfProfilePtr circleProfile(const Eigen::Vector2d& center, double radius);
SdfProfilePtr rectangleProfile(const Eigen::Vector2d& center, const Eigen::Vector2d& dimensions,
                               double rounding);
/// Simple polygon, either orientation.
SdfProfilePtr polygonProfile(Polyline corners);
/// Convex polygon, either orientation. Exact inside and before its sides; before a corner
/// the larger distance to the lines of its two sides, a lower bound: several times cheaper than
/// polygonProfile, for figures that are blended with others anyway.
SdfProfilePtr convexProfile(const Polyline& corners);
/// All points within half_width of a polyline: a bent sheet, once extruded. Ends are round.
SdfProfilePtr strokeProfile(Polyline points, double half_width);

/// Catmull-Rom curve through the points, `steps` pieces between neighbours.
Polyline smoothCurve(const Polyline& points, int steps);

}  // namespace hydrabench

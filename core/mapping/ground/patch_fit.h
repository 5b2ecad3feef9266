// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "core/config/config_reader.h"
#include "core/mapping/ground/plane.h"

namespace hydrabench {

/// A point in a bin.
struct BinPoint {
  Eigen::Vector3f position;  ///< [m], sensor frame, z up
  std::uint32_t index = 0;   ///< in the scan
};

/// What of a bin lies on one plane.
struct Patch {
  Plane plane;                   ///< of `points`
  std::vector<BinPoint> points;  ///< at most `thickness_m` above the plane, or below it
};

struct PatchFitConfig {
  int iterations = 3;
  int lowest_points = 20;        ///< whose mean height seeds are measured from
  double seed_height_m = 0.125;  ///< above that mean
  double thickness_m = 0.125;    ///< above the plane
  /// In the first zone points below this multiple of the sensor's height are not among the lowest:
  /// reflections seem to come from below the ground. Negative; -1 is the ground.
  double seed_margin = -1.2;
  double min_uprightness = 0.707;  ///< least z of a plane's normal that may be ground
  struct Vertical {                ///< R-VPF
    bool enabled = true;
    double seed_height_m = 0.25;
    double thickness_m = 0.1;  ///< to both sides of the plane
  } vertical;
};
void read(ConfigReader& reader, PatchFitConfig& config);

/// Patchwork's R-VPF, in the first zone, and R-GPF: takes points on steep planes away, then fits a
/// plane to the lowest points and to what is near it, several times.
/// @param points      of one bin; any order, which the result does not depend on but for last bits
/// @param first_zone  whether the bin is in it
/// @return            empty where fewer than three points are left for a plane
std::optional<Patch> fitPatch(std::vector<BinPoint> points, bool first_zone, double sensor_height_m,
                              const PatchFitConfig& config);

}  // namespace hydrabench

// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "core/mapping/ground/ground_scan.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "core/types/error.h"

namespace hydrabench {
namespace {

void requireLength(const GroundScan& scan, const char* name, std::size_t length) {
  if (length == 0 || length == scan.points.size()) return;
  throw InputError(
      fmt::format("the scan at {} ns has {} entries in '{}'; expected {}, one per point, or none",
                  scan.stamp_ns, length, name, scan.points.size()));
}

}  // namespace

std::size_t GroundMask::count(GroundClass wanted) const {
  return static_cast<std::size_t>(std::count(classes.begin(), classes.end(), wanted));
}

bool isMeasured(const Eigen::Vector3f& point) { return point.allFinite() && !point.isZero(0.0f); }

void requireUsable(const GroundScan& scan) {
  requireLength(scan, "intensity", scan.intensity.size());
  requireLength(scan, "lines", scan.lines.size());
  requireLength(scan, "labels", scan.labels.size());
  if (!std::isfinite(scan.sensor_height_m) || scan.sensor_height_m <= 0) {
    throw InputError(
        fmt::format("the scan at {} ns has a sensor_height_m of {:g}; expected the height of the "
                    "sensor above the ground, above 0",
                    scan.stamp_ns, scan.sensor_height_m));
  }
}

}  // namespace hydrabench

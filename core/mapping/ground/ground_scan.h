// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "core/types/ids.h"

namespace hydrabench {

/// One sweep of a LiDAR as a ground segmenter sees it. What is pointed to must outlive it; the
/// lists that are not empty have one entry per point.
struct GroundScan {
  std::int64_t stamp_ns = 0;
  /// N x 3 [m], the sensor at the origin, z up. A sensor that is mounted at an angle wants its
  /// points levelled first: rotated, not moved. Points that are not finite, or lie at the origin as
  /// drivers write a missing return, are passed over and counted.
  std::span<const Eigen::Vector3f> points;
  std::span<const float> intensity;      ///< 0 to 1; empty: not measured
  std::span<const std::uint16_t> lines;  ///< which laser measured the point; empty: not known
  std::span<const Label> labels;         ///< kUnknownLabel where none is known; empty: none is
  double sensor_height_m = 0;            ///< above the ground under the robot, > 0
};

/// Of a point. One byte, so that masks are passed on as they are.
enum class GroundClass : std::uint8_t {
  kNotJudged = 0,  ///< out of range, too few points around it, no label, or no measurement
  kGround = 1,
  kNonGround = 2,
};

/// What a segmenter says of a scan.
struct GroundMask {
  std::vector<GroundClass> classes;  ///< one per point, in their order
  std::size_t num_invalid = 0;       ///< points that are not finite or lie at the origin

  std::size_t count(GroundClass wanted) const;
};

/// False for points that are not finite or lie at the origin.
bool isMeasured(const Eigen::Vector3f& point);

/// Throws InputError, naming the scan's stamp, the field, its value and what was expected, where a
/// list has another length than `points`, or the height is not a positive number.
void requireUsable(const GroundScan& scan);

}  // namespace hydrabench

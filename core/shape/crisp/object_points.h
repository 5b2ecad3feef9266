// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "core/shape/shape_estimator.h"

namespace hydrabench {

/// The geometry of one view of one object, as the small network sees it: measured points on the
/// object and around it. Frame "level": origin at the camera, axes of the world (z up) [m].
struct ObjectPoints {
  std::vector<Eigen::Vector3f> object;  ///< of pixels in the mask
  std::vector<Eigen::Vector3f>
      context;  ///< of pixels outside of it: what it stands on, what hides it
  /// 1 where the mask reaches the left, upper, right, lower border of the image: the object may go
  /// on there.
  std::array<float, 4> cut = {0, 0, 0, 0};
};

struct ObjectPointsLimits {
  int object = 768;   ///< points kept at most, drawn evenly from all
  int context = 384;  ///< half of them from around the mask, half from the whole image
};

/// Needs images of the camera's size. Pixels without depth give no point.
ObjectPoints gatherObjectPoints(const ShapeObservation& observation,
                                const ObjectPointsLimits& limits, std::uint64_t seed);

}  // namespace hydrabench

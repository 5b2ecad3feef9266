// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/shape/crisp/object_points.h"
#include "core/types/random.h"

namespace hydrabench {

/// `count` points in a box of 0.8 x 0.4 x 0.6 m, 2 m before the camera and to the left, on a floor
/// 1 m below.
inline ObjectPoints toyPoints(std::size_t count, std::uint64_t seed = 1) {
  Random random(seed);
  ObjectPoints points;
  for (std::size_t i = 0; i < count; ++i) {
    points.object.push_back(Eigen::Vector3d(random.uniform(1.6, 2.4), random.uniform(0.4, 0.8),
                                            random.uniform(-1, -0.4))
                                .cast<float>());
  }
  for (int i = 0; i < 300; ++i) {
    points.context.push_back(
        Eigen::Vector3d(random.uniform(0.5, 4), random.uniform(-2, 3), -1).cast<float>());
  }
  points.cut = {0, 0, 1, 0};
  return points;
}

}  // namespace hydrabench

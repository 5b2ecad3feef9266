// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "core/geometry/transform.h"
#include "core/types/random.h"
#include "eval/simulation/shape_family.h"

namespace hydrabench {

/// Someone who walks, 1.5 to 1.9 m tall: a trunk with head, and arms and legs that are stiff and
/// swing about shoulders and hips. Frame of the figure: origin on the ground below the hips, x
/// ahead, z up.
struct Pedestrian {
  static constexpr double kHalfWidth_m = 0.32;  ///< nobody reaches farther to either side

  struct Limb {
    ShapeInstance shape;                              ///< its origin is the joint
    Eigen::Vector3d joint = Eigen::Vector3d::Zero();  ///< where the figure stands upright
    double swing_rad = 0;  ///< largest angle about y, negative where it begins in front
  };
  double height_m = 0;
  double leg_m = 0;         ///< from the hip to the sole
  double toe_m = 0;         ///< from the ankle to the tip of the shoe
  double stride_m = 0;      ///< two steps
  std::vector<Limb> limbs;  ///< trunk, left and right leg, left and right arm

  /// Pose of a limb after so many metres of walking. The hips rise and sink with the angle between
  /// the legs, such that the lower of the two shoes touches the ground.
  Transform limbPose(std::size_t limb, double walked_m) const;
};

/// A function of the random stream alone.
Pedestrian drawPedestrian(Random random);

}  // namespace hydrabench

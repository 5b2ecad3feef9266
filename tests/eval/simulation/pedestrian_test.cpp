// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/simulation/pedestrian.h"

#include <gtest/gtest.h>

namespace hydrabench {
namespace {

/// Around all limbs after so many metres, frame of the figure.
Aabb boundsAfter(const Pedestrian& person, const std::vector<SurfaceMesh>& limbs, double walked_m) {
  Aabb box;
  for (std::size_t i = 0; i < limbs.size(); ++i) {
    const Transform pose = person.limbPose(i, walked_m);
    for (const Eigen::Vector3d& vertex : limbs[i].mesh.vertices) box.extend(pose * vertex);
  }
  return box;
}

TEST(Pedestrian, IsAsTallAsPeopleAreAndKeepsAShoeOnTheGroundAtEveryStep) {
  for (const std::uint64_t seed : {1u, 2u, 3u, 4u}) {
    const Pedestrian person = drawPedestrian(Random(seed));
    std::vector<SurfaceMesh> limbs;
    for (const Pedestrian::Limb& limb : person.limbs) limbs.push_back(meshInstance(limb.shape));
    for (int step = 0; step < 20; ++step) {
      const Aabb box = boundsAfter(person, limbs, person.stride_m * step / 20);
      // Shoes are rounded: their edge floats a few millimetres.
      EXPECT_NEAR(box.min().z(), 0.004, 0.006) << step;
      EXPECT_GT(box.max().z(), 1.5);
      EXPECT_LT(box.max().z(), 1.96);
      EXPECT_LT(std::max(-box.min().y(), box.max().y()), Pedestrian::kHalfWidth_m);
    }
    EXPECT_NEAR(boundsAfter(person, limbs, 0).max().z(), person.height_m, 0.01 * person.height_m);
  }
}

TEST(Pedestrian, TakesTwoStepsAStrideWithLegsAndArmsCrosswise) {
  const Pedestrian person = drawPedestrian(Random(5));
  const auto ahead = [&](std::size_t limb, double share, double z) {
    return (person.limbPose(limb, share * person.stride_m) * Eigen::Vector3d(0, 0, z)).x();
  };
  const double sole = -person.leg_m;
  // A quarter of a stride after the feet were side by side, they are a step apart.
  EXPECT_NEAR(std::abs(ahead(1, 0.25, sole) - ahead(2, 0.25, sole)), 0.5 * person.stride_m, 1e-9);
  EXPECT_NEAR(ahead(1, 0.25, sole), ahead(2, 0.75, sole), 1e-9);
  EXPECT_NEAR(ahead(1, 0.5, sole), 0, 1e-9);
  EXPECT_LT(ahead(1, 0.25, -0.5) * ahead(3, 0.25, -0.5), 0);  // left leg and left arm
  EXPECT_GT(ahead(1, 0.25, -0.5) * ahead(4, 0.25, -0.5), 0);
}

}  // namespace
}  // namespace hydrabench

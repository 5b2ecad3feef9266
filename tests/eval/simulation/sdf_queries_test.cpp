// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/simulation/sdf_queries.h"

#include <gtest/gtest.h>

#include "eval/simulation/sdf_primitives.h"

namespace hydrabench {
namespace {

PlacedSdf at(const SdfPtr& sdf, double x) {
  Transform pose = Transform::Identity();
  pose.translation().x() = x;
  Aabb box = sdf->bounds();
  box.translate(pose.translation());
  return {sdf.get(), pose, box};
}

TEST(Interpenetrate, UnitSpheresMeetAtTwiceTheRadius) {
  const SdfPtr ball = sphere(Eigen::Vector3d::Zero(), 1);
  EXPECT_TRUE(interpenetrate(at(ball, 0), at(ball, 1.9), 0.001));
  EXPECT_FALSE(interpenetrate(at(ball, 0), at(ball, 2.1), 0.001));
  // They share a lens whose deepest point lies 5 cm inside both.
  EXPECT_FALSE(interpenetrate(at(ball, 0), at(ball, 1.9), 0.06));
}

TEST(Interpenetrate, NegativeToleranceAsksForAGap) {
  const SdfPtr ball = sphere(Eigen::Vector3d::Zero(), 1);
  const auto widened = [&](double x) {
    PlacedSdf placed = at(ball, x);
    placed.box.min().array() -= 0.1;
    placed.box.max().array() += 0.1;
    return placed;
  };
  // The point in the middle of the gap is 5 cm from both.
  EXPECT_TRUE(interpenetrate(widened(0), widened(2.1), -0.06));
  EXPECT_FALSE(interpenetrate(widened(0), widened(2.1), -0.04));
}

TEST(TightBounds, AreWithinToleranceOfASphere) {
  const Aabb box = tightBounds(*sphere({1, 2, 3}, 0.5), 0.004);
  const Aabb exact(Eigen::Vector3d(0.5, 1.5, 2.5), Eigen::Vector3d(1.5, 2.5, 3.5));
  EXPECT_TRUE((box.min() - exact.min()).cwiseAbs().maxCoeff() < 0.01) << box.min().transpose();
  EXPECT_TRUE((box.max() - exact.max()).cwiseAbs().maxCoeff() < 0.01) << box.max().transpose();
}

TEST(HeightBelow, FindsTheTopOfATable) {
  const SdfPtr table = standingBox({0, 0, 0.7}, {1, 1, 0.05}, 0.005);
  EXPECT_NEAR(heightBelow(*table, {0.1, 0.2, 1.5}).value(), 0.75, 2e-4);
  EXPECT_FALSE(heightBelow(*table, {2, 0, 1.5}).has_value());
}

}  // namespace
}  // namespace hydrabench

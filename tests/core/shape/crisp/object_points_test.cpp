// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "core/shape/crisp/object_points.h"

#include <algorithm>
#include <limits>

#include <gtest/gtest.h>

#include "tests/core/shape/crisp/ball_view.h"

namespace hydrabench {
namespace {

Eigen::Vector3d inCamera(const ShapeObservation& view, const Eigen::Vector3f& p_level) {
  return view.T_world_camera.linear().transpose() * p_level.cast<double>();
}

TEST(ObjectPoints, OfTheObjectLieOnItAndTheRestDoesNot) {
  ShapeObservation view = viewOfABall();
  view.T_world_camera.translation() = Eigen::Vector3d(5, -3, 1);  // does not matter
  const ObjectPoints points = gatherObjectPoints(view, {}, 1);
  ASSERT_GT(points.object.size(), 100u);
  for (const Eigen::Vector3f& p : points.object) {
    EXPECT_NEAR((inCamera(view, p) - kBallCenter).norm(), kBallRadius, 1e-5);
  }
  ASSERT_EQ(points.context.size(), 384u);
  for (const Eigen::Vector3f& p : points.context) EXPECT_NEAR(inCamera(view, p).z(), 4, 1e-5);
  EXPECT_EQ(points.cut, (std::array<float, 4>{0, 0, 0, 0}));
}

TEST(ObjectPoints, AxesAreThoseOfTheWorld) {
  ShapeObservation view = viewOfABall();
  const ObjectPoints points = gatherObjectPoints(view, {}, 1);
  const Eigen::Vector3d center = view.T_world_camera.linear() * kBallCenter;
  EXPECT_LT(center.z(), -0.4);  // the camera looks down
  float lowest = 0;
  for (const Eigen::Vector3f& p : points.object) lowest = std::min(lowest, p.z());
  EXPECT_GT(lowest, center.z() - kBallRadius - 1e-5);
}

TEST(ObjectPoints, AreNoMoreThanTheLimitsAndDrawnBySeed) {
  const ShapeObservation view = viewOfABall();
  const ObjectPointsLimits limits{.object = 50, .context = 20};
  const ObjectPoints a = gatherObjectPoints(view, limits, 1);
  const ObjectPoints b = gatherObjectPoints(view, limits, 1);
  const ObjectPoints c = gatherObjectPoints(view, limits, 2);
  EXPECT_EQ(a.object.size(), 50u);
  EXPECT_EQ(a.context.size(), 20u);
  EXPECT_EQ(a.object, b.object);
  EXPECT_EQ(a.context, b.context);
  EXPECT_NE(a.object, c.object);
}

TEST(ObjectPoints, PixelsWithoutDepthGiveNone) {
  ShapeObservation view = viewOfABall();
  const std::size_t all = gatherObjectPoints(view, {5000, 10}, 1).object.size();
  int spoilt = 0;
  for (std::size_t i = 0; i < view.mask.size() && spoilt < 30; ++i) {
    if (!view.mask.data()[i]) continue;
    constexpr float kBad[] = {0, -1, std::numeric_limits<float>::quiet_NaN(),
                              std::numeric_limits<float>::infinity()};
    view.depth.data()[i] = kBad[spoilt++ % 4];
  }
  const ObjectPoints points = gatherObjectPoints(view, {5000, 10}, 1);
  EXPECT_EQ(points.object.size(), all - 30);
  for (const Eigen::Vector3f& p : points.object) EXPECT_TRUE(p.allFinite());
}

TEST(ObjectPoints, SayWhichBordersCutTheMask) {
  ShapeObservation view = viewOfABall();
  view.mask(0, 30) = 1;
  EXPECT_EQ(gatherObjectPoints(view, {}, 1).cut, (std::array<float, 4>{1, 0, 0, 0}));
  view.mask(40, 59) = 1;
  EXPECT_EQ(gatherObjectPoints(view, {}, 1).cut, (std::array<float, 4>{1, 0, 0, 1}));
}

TEST(ObjectPoints, AnEmptyMaskHasNone) {
  ShapeObservation view = viewOfABall();
  view.mask = Image<std::uint8_t>(80, 60, 0);
  const ObjectPoints points = gatherObjectPoints(view, {}, 1);
  EXPECT_TRUE(points.object.empty());
  EXPECT_TRUE(points.context.empty());
}

}  // namespace
}  // namespace hydrabench

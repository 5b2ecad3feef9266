// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "core/mapping/ground/patch_fit.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

namespace hydrabench {
namespace {

constexpr double kHeight = 1.7;

void add(std::vector<BinPoint>& points, float x, float y, float z) {
  points.push_back({{x, y, z}, static_cast<std::uint32_t>(points.size())});
}

/// 10 x 10 points over a square of 3 m at z = -1.7 + slope * x.
std::vector<BinPoint> floorPoints(float slope = 0) {
  std::vector<BinPoint> points;
  for (int i = 0; i < 100; ++i) {
    const float x = 4 + 0.3f * static_cast<float>(i % 10);
    const float y = 0.3f * static_cast<float>(i / 10);
    add(points, x, y, -1.7f + slope * (x - 4));
  }
  return points;
}

TEST(PatchFit, TakesThePointsUpToTheThicknessAboveThePlane) {
  std::vector<BinPoint> points = floorPoints();
  add(points, 5, 1, -1.7f + 0.12f);
  add(points, 5, 1, -1.7f + 0.14f);
  const auto patch = fitPatch(points, false, kHeight, {});
  ASSERT_TRUE(patch);
  EXPECT_EQ(patch->points.size(), 101u);
  EXPECT_EQ(patch->points.back().index, 100u);
  EXPECT_NEAR(patch->plane.mean.z(), -1.7 + 0.12 / 101, 1e-6);
}

TEST(PatchFit, FollowsASlope) {
  const auto patch = fitPatch(floorPoints(0.5f), false, kHeight, {});
  ASSERT_TRUE(patch);
  EXPECT_EQ(patch->points.size(), 100u);
  EXPECT_NEAR(patch->plane.normal.x(), -0.5 / std::sqrt(1.25), 1e-5);
  EXPECT_NEAR(patch->plane.flatness(), 0, 1e-9);
}

/// A wall that goes down 0.3 m beside the floor, as at a terrace edge.
std::vector<BinPoint> floorAndWallBelow() {
  std::vector<BinPoint> points = floorPoints();
  for (int i = 0; i < 60; ++i) {
    add(points, 3.8f, 0.05f * static_cast<float>(i), -1.76f - 0.06f * static_cast<float>(i % 5));
  }
  return points;
}

TEST(PatchFit, SteepPlanesUnderTheGroundAreTakenAwayInTheFirstZone) {
  const auto patch = fitPatch(floorAndWallBelow(), true, kHeight, {});
  ASSERT_TRUE(patch);
  EXPECT_EQ(patch->points.size(), 100u);
  EXPECT_NEAR(patch->plane.normal.z(), 1, 1e-6);
  // Without the step, and outside the first zone, the wall stays.
  PatchFitConfig without;
  without.vertical.enabled = false;
  EXPECT_GT(fitPatch(floorAndWallBelow(), true, kHeight, without)->points.size(), 100u);
  EXPECT_GT(fitPatch(floorAndWallBelow(), false, kHeight, {})->points.size(), 100u);
}

TEST(PatchFit, PointsBelowTheMarginAreNotTheLowestInTheFirstZone) {
  std::vector<BinPoint> points = floorPoints();
  for (int i = 0; i < 20; ++i) {
    add(points, 4.15f + 0.6f * static_cast<float>(i % 5), 0.3f + 0.7f * static_cast<float>(i / 5),
        -2.3f);
  }
  const auto patch = fitPatch(points, true, kHeight, {});
  ASSERT_TRUE(patch);
  EXPECT_EQ(patch->points.size(), 120u) << "the floor, and all that is below it";
  // Elsewhere the 20 are all there is of seeds.
  const auto farther = fitPatch(points, false, kHeight, {});
  ASSERT_TRUE(farther);
  EXPECT_EQ(farther->points.size(), 20u);
}

TEST(PatchFit, GivesUpBelowThreePoints) {
  std::vector<BinPoint> points;
  EXPECT_FALSE(fitPatch(points, true, kHeight, {}));
  add(points, 4, 0, -1.7f);
  add(points, 4, 1, -1.7f);
  EXPECT_FALSE(fitPatch(points, false, kHeight, {}));
}

TEST(PatchFit, TheOrderOfPointsDoesNotMatter) {
  std::vector<BinPoint> points = floorAndWallBelow();
  const auto forward = fitPatch(points, true, kHeight, {});
  std::reverse(points.begin(), points.end());
  const auto backward = fitPatch(points, true, kHeight, {});
  ASSERT_TRUE(forward && backward);
  EXPECT_EQ(forward->points.size(), backward->points.size());
  EXPECT_TRUE(forward->plane.normal.isApprox(backward->plane.normal, 1e-12));
}

}  // namespace
}  // namespace hydrabench

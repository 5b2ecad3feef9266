// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "core/mapping/ground/plane.h"

#include <cmath>
#include <limits>
#include <tuple>

#include <gtest/gtest.h>

namespace hydrabench {
namespace {

TEST(Plane, OfFourCornersAndTheirHeights) {
  PlaneMoments moments;
  // A 4 x 2 rectangle at z = -1, corners 0.1 up and down by turns: variances 16/3, 4/3, 0.04/3.
  for (const auto& [x, y, z] :
       {std::tuple{2.f, 1.f, -0.9f}, {2.f, -1.f, -1.1f}, {-2.f, 1.f, -1.1f}, {-2.f, -1.f, -0.9f}}) {
    moments.add({x, y, z});
  }
  const auto plane = moments.plane();
  ASSERT_TRUE(plane);
  EXPECT_NEAR(plane->mean.z(), -1, 1e-7);
  EXPECT_NEAR(plane->variances.x(), 16.0 / 3, 1e-6);
  EXPECT_NEAR(plane->variances.y(), 4.0 / 3, 1e-6);
  EXPECT_NEAR(plane->flatness(), 0.04 / 3, 1e-6);
  EXPECT_NEAR(plane->lineRatio(), 4, 1e-6);
  EXPECT_NEAR(plane->normal.z(), 1, 1e-9);
  EXPECT_NEAR(plane->signedDistance({7, 7, 0.5f}), 1.5, 1e-6);
  EXPECT_NEAR(plane->signedDistance({7, 7, -1.5f}), -0.5, 1e-6);
}

TEST(Plane, NormalsPointUp) {
  for (const float slope : {-3.f, -0.1f, 0.1f, 3.f}) {
    PlaneMoments moments;
    for (const float x : {0.f, 1.f, 2.f}) {
      for (const float y : {0.f, 1.f}) moments.add({x, y, slope * x});
    }
    EXPECT_NEAR(moments.plane()->normal.z(), 1 / std::sqrt(1 + double{slope * slope}), 1e-6);
  }
}

TEST(Plane, NeedsThreePoints) {
  PlaneMoments moments;
  moments.add({0, 0, 0});
  moments.add({1, 0, 0});
  EXPECT_FALSE(moments.plane());
  moments.add({2, 0, 0});
  ASSERT_TRUE(moments.plane());
  EXPECT_EQ(moments.plane()->lineRatio(), std::numeric_limits<double>::infinity());
}

}  // namespace
}  // namespace hydrabench

// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "core/mapping/lidar_projection.h"

#include <gtest/gtest.h>

#include "core/types/random.h"

namespace hydrabench {
namespace {

constexpr double kDegree = std::numbers::pi / 180;
const LidarModel kLidar = {
    .columns = 1800, .rows = 16, .top_rad = 15 * kDegree, .bottom_rad = -15 * kDegree};

TEST(LidarModel, LooksAheadInTheMiddleColumnAndLeftInTheOneBefore) {
  EXPECT_NEAR((kLidar.direction(900, 7.5) - Eigen::Vector3d::UnitX()).norm(), 0, 1e-12);
  EXPECT_NEAR((kLidar.direction(450, 7.5) - Eigen::Vector3d::UnitY()).norm(), 0, 1e-12);
  EXPECT_NEAR(kLidar.direction(123, 0).z(), std::sin(15 * kDegree), 1e-12);
  EXPECT_NEAR(kLidar.direction(123, 15).z(), -std::sin(15 * kDegree), 1e-12);
}

TEST(FastAtan2, AgreesWithTheLibraryToAMillionth) {
  for (int i = -720; i <= 720; ++i) {
    const double angle = i * std::numbers::pi / 720.5;
    const auto y = static_cast<float>(7 * std::sin(angle));
    const auto x = static_cast<float>(7 * std::cos(angle));
    EXPECT_NEAR(fastAtan2(y, x), std::atan2(y, x), 1e-6) << angle;
  }
  EXPECT_EQ(fastAtan2(0, 0), 0);
}

TEST(LidarProjection, FindsThePixelOfARay) {
  const LidarProjection projection(kLidar);
  for (const double u : {0.25, 10.0, 899.5, 1799.75}) {
    for (const double v : {-0.4, 0.0, 7.3, 15.4}) {
      float found_u = 0;
      float found_v = 0;
      ASSERT_TRUE(
          projection.project((12 * kLidar.direction(u, v)).cast<float>(), found_u, found_v));
      EXPECT_NEAR(found_u, u, 1e-3);
      EXPECT_NEAR(found_v, v, 1e-4);
    }
  }
  float u = 0;
  float v = 0;
  EXPECT_FALSE(projection.project(kLidar.direction(3, -0.6).cast<float>(), u, v));
  EXPECT_FALSE(projection.project(kLidar.direction(3, 15.6).cast<float>(), u, v));
}

TEST(LidarProjection, HasAllOfACubeWithinItsFootprint) {
  const LidarProjection projection(kLidar);
  int decided = 0;
  for (int cube = 0; cube < 500; ++cube) {
    Random random(9, static_cast<std::uint64_t>(cube));
    const Eigen::Vector3d low(random.uniform(-20, 20), random.uniform(-20, 20),
                              random.uniform(-6, 6));
    const double side = random.uniform(0.1, 4);
    std::array<Eigen::Vector3d, 8> corners;
    for (std::size_t i = 0; i < 8; ++i) {
      corners[i] = low + side * Eigen::Vector3d(i & 1 ? 1 : 0, i & 2 ? 1 : 0, i & 4 ? 1 : 0);
    }
    const Footprint footprint = projection.footprint(corners);
    decided += footprint.outside || footprint.inside;
    for (int i = 0; i < 50; ++i) {
      const Eigen::Vector3d p =
          low +
          side * Eigen::Vector3d(random.uniform(0, 1), random.uniform(0, 1), random.uniform(0, 1));
      float u = 0;
      float v = 0;
      const bool seen = projection.project(p.cast<float>(), u, v);
      ASSERT_FALSE(seen && footprint.outside);
      ASSERT_TRUE(seen || !footprint.inside);
      if (!seen) continue;
      EXPECT_GE(static_cast<int>(u), footprint.pixels.u0);
      EXPECT_LE(std::min(static_cast<int>(u) + 1, 1800), footprint.pixels.u1);
      EXPECT_GE(std::max(static_cast<int>(v), 0), footprint.pixels.v0);
      EXPECT_LE(std::min(static_cast<int>(v) + 1, 15), footprint.pixels.v1);
    }
  }
  EXPECT_GT(decided, 100);  // a footprint that is always everything would pass the rest
}

}  // namespace
}  // namespace hydrabench

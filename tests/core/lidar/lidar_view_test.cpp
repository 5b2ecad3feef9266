// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "core/lidar/lidar_view.h"

#include <gtest/gtest.h>

#include "tests/core/lidar/scans.h"

namespace hydrabench {
namespace {

TEST(LidarView, HasEveryPointInThePixelOfItsRay) {
  const LidarScan scan = scanOfGround(0.5);
  const LidarView picture(scan, {.points = scan.points}, 0.4, 40);
  const SensorView& view = picture.view();
  ASSERT_EQ(view.range.width(), 361);
  ASSERT_EQ(view.range.height(), 16);
  for (int v = 0; v < 16; ++v) {
    for (const int u : {0, 1, 90, 180, 359}) {
      const double z = scan.lidar.direction(u, v).z();
      EXPECT_NEAR(view.range(u, v), z < 0 ? -0.5 / z : 0, 1e-4) << u << " " << v;
    }
  }
  EXPECT_NEAR(view.max_measured_m, 0.5 / std::sin(std::numbers::pi / 180), 1e-3);
}

TEST(LidarView, RepeatsTheFirstColumnBehindTheLast) {
  LidarScan scan = scanOfGround(0.5);
  scan.points[0] *= 2;  // row 8, column 0
  const LidarView picture(scan, {.points = scan.points}, 0.4, 80);
  for (int v = 0; v < 16; ++v) EXPECT_EQ(picture.view().range(360, v), picture.view().range(0, v));
  EXPECT_NE(picture.view().range(0, 8), picture.view().range(1, 8));
}

TEST(LidarView, TakesTheNearestOfSeveralPointsWithWhatIsKnownOfIt) {
  LidarScan scan;
  scan.lidar = sixteenRows();
  const Eigen::Vector3f ray = scan.lidar.direction(40, 3).cast<float>();
  scan.points = {5 * ray, 3 * ray, 4 * ray, 0.2f * ray, Eigen::Vector3f::Zero()};
  const std::vector<Label> labels = {1, 2, 3, 4, 5};
  const std::vector<GroundClass> ground = {GroundClass::kNonGround, GroundClass::kGround,
                                           GroundClass::kNonGround, GroundClass::kNonGround,
                                           GroundClass::kNotJudged};
  const std::vector<std::uint8_t> moving = {0, 1, 0, 0, 0};
  const LidarView picture(
      scan, {.points = scan.points, .labels = labels, .ground = ground, .moving = moving}, 0.4, 40);
  EXPECT_FLOAT_EQ(picture.view().range(40, 3), 3);  // 0.2 m is nearer than the sensor measures
  EXPECT_EQ((*picture.view().labels)(40, 3), 2);
  EXPECT_EQ((*picture.view().ground)(40, 3), 1);
  EXPECT_EQ((*picture.view().mask)(40, 3), 1);
  EXPECT_EQ((*picture.view().labels)(41, 3), kUnknownLabel);
  EXPECT_EQ((*picture.view().ground)(41, 3), 0);
}

TEST(LidarView, PassesOverPointsAboveAndBelowItsRows) {
  LidarScan scan;
  scan.lidar = sixteenRows();
  scan.points = {{0.1f, 0, 5}, {0.1f, 0, -5}};
  const LidarView picture(scan, {.points = scan.points}, 0.4, 40);
  EXPECT_EQ(picture.view().max_measured_m, 0);
}

}  // namespace
}  // namespace hydrabench

// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/view/scan_picture.h"

#include <gtest/gtest.h>

namespace hydrabench {
namespace {

LidarScan scanOf(std::vector<Eigen::Vector3f> points) {
  LidarScan scan;
  scan.lidar = {.columns = 360, .rows = 3, .top_rad = 0.2, .bottom_rad = -0.2};
  scan.points = std::move(points);
  return scan;
}

bool isRed(const Rgb& color) { return color.r > color.b; }

TEST(ScanPicture, AheadIsUpAndLeftIsLeftWithHighPointsRed) {
  const Image<Rgb> picture = scanPicture(scanOf({{10, 0, 2}, {0, 5, -2}}), 15);
  EXPECT_TRUE(isRed(picture(450, 150)));  // 30 pixels a metre
  EXPECT_NE(picture(300, 450), Rgb{});
  EXPECT_FALSE(isRed(picture(300, 450)));
  EXPECT_EQ(picture(450, 450), Rgb{});
}

TEST(ScanPicture, StraightAheadIsTheMiddleOfTheBandBelow) {
  const Image<Rgb> picture = scanPicture(scanOf({{2, 0, 0}, {0, 20, 0}}), 25);
  const int middle = picture.height() - 3 * 64 / 2;
  EXPECT_TRUE(isRed(picture(450, middle)));
  EXPECT_NE(picture(225, middle), Rgb{});
  EXPECT_FALSE(isRed(picture(225, middle)));
  EXPECT_EQ(picture(675, middle), Rgb{});
  EXPECT_EQ(picture(450, middle - 64), Rgb{});
}

TEST(ScanPicture, MissingReturnsAreNotDrawn) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  EXPECT_TRUE(scanPicture(scanOf({{0, 0, 0}, {nan, 1, 0}}), 15) == scanPicture(scanOf({}), 15));
}

TEST(ScanPicture, MotionDuringTheSweepIsUndone) {
  LidarScan scan = scanOf({{9, 0, 0}});
  scan.times = {0};
  scan.T_world_lidar.translation().x() = 3;  // three metres on, the point is six metres ahead
  const Image<Rgb> picture = scanPicture(scan, 15);
  EXPECT_NE(picture(450, 450 - 6 * 30), Rgb{});
  EXPECT_EQ(picture(450, 450 - 9 * 30), Rgb{});
}

}  // namespace
}  // namespace hydrabench

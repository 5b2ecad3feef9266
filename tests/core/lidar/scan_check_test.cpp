// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "core/lidar/scan_check.h"

#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/types/error.h"
#include "tests/core/lidar/scans.h"

namespace hydrabench {
namespace {

std::string faultOf(const LidarScan& scan) {
  try {
    requireUsable(scan);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(ScanCheck, AcceptsAScanWithPointsThatDidNotReturn) {
  LidarScan scan = scanOfGround(0.5);
  scan.points[0].setZero();
  scan.points[1].setConstant(std::numeric_limits<float>::quiet_NaN());
  EXPECT_EQ(faultOf(scan), "");
}

TEST(ScanCheck, NamesTheListOfAnotherLength) {
  LidarScan scan = scanOfGround(0.5);
  scan.intensity.resize(3);
  EXPECT_EQ(faultOf(scan),
            "the lidar scan at 1 ns has 3 entries in 'intensity'; expected 2880, one per point, or "
            "none");
}

TEST(ScanCheck, NamesARingTheSensorDoesNotHave) {
  LidarScan scan = scanOfGround(0.5);
  scan.rings[7] = 16;
  EXPECT_EQ(faultOf(scan),
            "the lidar scan at 1 ns has a point of ring 16; expected rings below 16, the rows of "
            "the sensor");
}

TEST(ScanCheck, RefusesTimesOutsideTheSweepAndSweepsThatEndBeforeTheyStart) {
  LidarScan scan = scanOfGround(0.5);
  scan.times.assign(scan.points.size(), 0.5f);
  EXPECT_EQ(faultOf(scan), "");
  scan.times[9] = 1.5f;
  EXPECT_THAT(faultOf(scan), testing::HasSubstr("a point at 1.5 of the sweep; expected 0 to 1"));
  scan.times[9] = std::numeric_limits<float>::quiet_NaN();
  EXPECT_THAT(faultOf(scan), testing::HasSubstr("a point at nan of the sweep"));
  scan.times.clear();
  scan.start_ns = 2;
  EXPECT_THAT(faultOf(scan), testing::HasSubstr("starts at 2 ns"));
}

TEST(ScanCheck, RefusesASensorWithoutRowsAndAPoseThatIsNotFinite) {
  LidarScan scan = scanOfGround(0.5);
  scan.lidar.rows = 0;
  EXPECT_THAT(faultOf(scan), testing::HasSubstr("0 rows and 360 columns; expected at least 2"));
  scan = scanOfGround(0.5);
  std::swap(scan.lidar.top_rad, scan.lidar.bottom_rad);
  EXPECT_THAT(faultOf(scan), testing::HasSubstr("the first the higher"));
  scan = scanOfGround(0.5);
  scan.T_world_lidar.translation().x() = std::numeric_limits<double>::infinity();
  EXPECT_THAT(faultOf(scan), testing::HasSubstr("a pose that is not finite"));
}

}  // namespace
}  // namespace hydrabench

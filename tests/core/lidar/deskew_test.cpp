// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "core/lidar/deskew.h"

#include <gtest/gtest.h>

#include "tests/core/lidar/scans.h"

namespace hydrabench {
namespace {

/// A sweep of a wall at x = 10 m of the world, by a sensor that drives 1 m toward it and turns left
/// by 30 degrees meanwhile.
LidarScan sweepOfWall() {
  LidarScan scan;
  scan.stamp_ns = 100;
  scan.lidar = sixteenRows();
  scan.T_world_lidar.translation().x() = 1;
  scan.T_world_lidar.rotate(Eigen::AngleAxisd(std::numbers::pi / 6, Eigen::Vector3d::UnitZ()));
  for (int i = 0; i <= 100; ++i) {
    const double time = i / 100.0;
    const Transform T_world_then = interpolate(scan.T_world_lidar_start, scan.T_world_lidar, time);
    const Eigen::Vector3d on_wall(10, 0.2 * i - 10, 0.01 * i);
    scan.points.push_back((T_world_then.inverse() * on_wall).cast<float>());
    scan.times.push_back(static_cast<float>(time));
  }
  return scan;
}

double farthestFromWall(const LidarScan& scan, const std::vector<Eigen::Vector3f>& points) {
  double farthest = 0;
  for (const Eigen::Vector3f& p : points) {
    farthest = std::max(farthest, std::abs((scan.T_world_lidar * p.cast<double>()).x() - 10));
  }
  return farthest;
}

TEST(Deskew, PutsEveryPointOfAWallBackOntoIt) {
  const LidarScan scan = sweepOfWall();
  EXPECT_LT(farthestFromWall(scan, deskewed(scan)), 1e-5);
  EXPECT_GT(farthestFromWall(scan, scan.points), 1);
}

TEST(Deskew, RoundsTimesToAThousandthOfTheSweep) {
  LidarScan scan = sweepOfWall();
  for (float& time : scan.times) time = std::min(1.0f, time + 0.0004f);
  EXPECT_LT(farthestFromWall(scan, deskewed(scan)), 1e-5);
}

TEST(Deskew, LeavesPointsAloneThatHaveNoTimeOrNoReturn) {
  LidarScan scan = sweepOfWall();
  scan.points[3].setZero();
  EXPECT_TRUE(deskewed(scan)[3].isZero());
  scan.times.clear();
  EXPECT_EQ(deskewed(scan), scan.points);
}

TEST(Levelled, TurnsTheWorldsUpwardAxisUpAndNothingElse) {
  Transform T_world_points = Transform::Identity();
  T_world_points.translation() = Eigen::Vector3d(3, 4, 5);
  T_world_points.rotate(Eigen::AngleAxisd(0.2, Eigen::Vector3d(0.6, 0.8, 0)));
  const Eigen::Vector3d up = T_world_points.linear().transpose() * Eigen::Vector3d::UnitZ();
  const auto level = levelled({(2 * up).cast<float>(), {0.6f, 0.8f, 0}}, T_world_points);
  EXPECT_LT((level[0] - Eigen::Vector3f(0, 0, 2)).norm(), 1e-6);
  EXPECT_LT((level[1] - Eigen::Vector3f(0.6f, 0.8f, 0)).norm(), 1e-6);  // the axis of the tilt
}

}  // namespace
}  // namespace hydrabench

// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "core/lidar/lidar_depth.h"

#include <gtest/gtest.h>

namespace hydrabench {
namespace {

Frame blank() {
  Frame frame;
  frame.camera = {100, 80, 100, 100, 50, 40};
  return frame;
}

TEST(LidarDepth, IsTheDepthOfTheNearestPointInAPixel) {
  LidarDepth depth({.scans = 1, .fill_px = 0});
  depth.add({{0, 0, 2.1f}, {0, 0, 2}, {0.2f, 0, 2}}, Transform::Identity());
  const Image<float> image = depth.depth(blank());
  EXPECT_FLOAT_EQ(image(50, 40), 2);
  EXPECT_FLOAT_EQ(image(60, 40), 2);
  EXPECT_EQ(image(55, 40), 0);
}

TEST(LidarDepth, ProjectsTheLastScansEachByItsPose) {
  LidarDepth depth({.scans = 2, .fill_px = 0});
  for (const double x : {0.0, 0.2, -0.2}) {
    Transform T_world_points = Transform::Identity();
    T_world_points.translation().x() = x;
    depth.add({{0, 0, 2}}, T_world_points);
  }
  const Image<float> image = depth.depth(blank());
  EXPECT_EQ(image(50, 40), 0);  // the first of three
  EXPECT_FLOAT_EQ(image(60, 40), 2);
  EXPECT_FLOAT_EQ(image(40, 40), 2);
}

TEST(FilledDepth, TakesTheNearestMeasurementWithinReach) {
  Image<float> depth(20, 1);
  depth(3, 0) = 1;
  depth(9, 0) = 2;
  const Image<float> filled = filledDepth(depth, {}, 4);
  EXPECT_EQ(filled(0, 0), 1);
  EXPECT_EQ(filled(5, 0), 1);
  EXPECT_EQ(filled(6, 0), 1);  // as far from both: the left one
  EXPECT_EQ(filled(7, 0), 2);
  EXPECT_EQ(filled(13, 0), 2);
  EXPECT_EQ(filled(14, 0), 0);
}

TEST(FilledDepth, NeverReachesIntoAnotherInstance) {
  Image<float> depth(20, 1);
  depth(3, 0) = 1;
  Image<InstanceId> instances(20, 1);
  for (int u = 5; u < 20; ++u) instances(u, 0) = 4;
  const Image<float> filled = filledDepth(depth, instances, 4);
  EXPECT_EQ(filled(4, 0), 1);
  EXPECT_EQ(filled(5, 0), 0);
}

}  // namespace
}  // namespace hydrabench

// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "tests/support/miniature_world.h"

#include <gtest/gtest.h>

namespace hydrabench {
namespace {

using Eigen::Vector3d;
namespace id = miniature_label;

const Transform kAhead = lookAt(Vector3d(0, 0, 0.5), Vector3d(1, 0, 0.5));

TEST(MiniatureWorld, DepthIsAlongTheOpticalAxis) {
  MiniatureWorld world;
  world.add(boxMesh(Aabb(Vector3d(2, -9, -9), Vector3d(3, 9, 9))), id::kWall);
  const Frame frame = world.frame(kAhead, 1);
  for (const float depth : frame.depth) ASSERT_NEAR(depth, 2, 1e-5);
  EXPECT_EQ(frame.labels(3, 4), id::kWall);
  EXPECT_EQ(frame.instances(3, 4), kNoInstance);
  EXPECT_TRUE(frame.instance_labels.empty());
}

TEST(MiniatureWorld, PixelsThatSeeNothingHaveNoDepth) {
  MiniatureWorld world;
  world.add(boxMesh(Aabb(Vector3d(2, -0.5, 0), Vector3d(3, 0.5, 1))), id::kBin, 7);
  const Frame frame = world.frame(kAhead, 1);
  EXPECT_EQ(frame.depth(0, 0), 0);
  EXPECT_EQ(frame.labels(0, 0), kUnknownLabel);
  EXPECT_NEAR(frame.depth(90, 60), 2, 1e-5);
  EXPECT_EQ(frame.instances(90, 60), 7);
  EXPECT_EQ(frame.instance_labels, (std::map<InstanceId, Label>{{7, id::kBin}}));
}

TEST(MiniatureWorld, AMovingThingIsDrawnWhereItIsAndHidesWhatIsBehind) {
  MiniatureWorld world;
  world.add(boxMesh(Aabb(Vector3d(4, -9, -9), Vector3d(5, 9, 9))), id::kWall);
  world.add(
      boxMesh(Aabb(Vector3d(3, -0.5, 0), Vector3d(3.5, 0.5, 1))), id::kHuman, 1,
      [](std::int64_t stamp_ns) { return pose(-1e-9 * static_cast<double>(stamp_ns), 0, 0, 0); });
  EXPECT_NEAR(world.frame(kAhead, 0).depth(90, 60), 3, 1e-5);
  EXPECT_NEAR(world.frame(kAhead, 1'000'000'000).depth(90, 60), 2, 1e-5);
  EXPECT_NEAR(world.frame(kAhead, 1'000'000'000).depth(0, 0), 4, 1e-5);
}

TEST(MiniatureWorld, ShuffledIdsDifferFromFrameToFrameAndKeepTheirClass) {
  MiniatureWorld world;
  world.add(boxMesh(Aabb(Vector3d(2, -0.5, 0), Vector3d(3, 0.5, 1))), id::kBin, 7);
  world.shuffleInstanceIds();
  const Frame first = world.frame(kAhead, 1);
  const Frame second = world.frame(kAhead, 2);
  EXPECT_NE(first.instances(90, 60), second.instances(90, 60));
  EXPECT_EQ(second.instance_labels.at(second.instances(90, 60)), id::kBin);
}

TEST(MiniatureWorld, AConfusedObjectIsAnotherClassInThatFrameOnly) {
  MiniatureWorld world;
  world.add(boxMesh(Aabb(Vector3d(2, -0.5, 0), Vector3d(3, 0.5, 1))), id::kBin, 7);
  world.confuse(7, id::kChair, 2);
  EXPECT_EQ(world.frame(kAhead, 1).instance_labels.at(7), id::kBin);
  EXPECT_EQ(world.frame(kAhead, 2).instance_labels.at(7), id::kChair);
  EXPECT_EQ(world.frame(kAhead, 2).labels(90, 60), id::kChair);
}

}  // namespace
}  // namespace hydrabench

// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "core/geometry/pose_interpolation.h"

#include <numbers>
#include <vector>

#include <gtest/gtest.h>

namespace hydrabench {
namespace {

constexpr std::int64_t kEpoch_ns = 1'700'000'000'000'000'000;  // a stamp of today has 61 bits

TimedPose poseWith(std::int64_t after_ns, const Eigen::Vector3d& position, double yaw) {
  TimedPose pose{kEpoch_ns + after_ns, Transform::Identity()};
  pose.T_world_body.translation() = position;
  pose.T_world_body.linear() = Eigen::AngleAxisd(yaw, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  return pose;
}

TEST(PoseAt, AQuarterOfTheTimeIsAQuarterOfTheWayAndOfTheTurn) {
  const std::vector<TimedPose> poses = {poseWith(0, {1, 2, 3}, 0),
                                        poseWith(200, {5, 2, -1}, std::numbers::pi / 2)};
  const auto pose = poseAt(poses, kEpoch_ns + 50);
  ASSERT_TRUE(pose);
  EXPECT_TRUE(pose->isApprox(poseWith(50, {2, 2, 2}, std::numbers::pi / 8).T_world_body, 1e-14));
}

TEST(PoseAt, TurnsTheShorterWayAround) {
  const std::vector<TimedPose> poses = {poseWith(0, {0, 0, 0}, 3.0), poseWith(2, {0, 0, 0}, -3.0)};
  const auto pose = poseAt(poses, kEpoch_ns + 1);
  ASSERT_TRUE(pose);
  EXPECT_NEAR(
      rotationAngle(pose->linear(), poseWith(0, {0, 0, 0}, std::numbers::pi).T_world_body.linear()),
      0, 1e-12);
}

TEST(PoseAt, AtAGivenStampItIsTheGivenPoseToTheBit) {
  const std::vector<TimedPose> poses = {poseWith(0, {1.0 / 3, 0, 0}, 0.1),
                                        poseWith(7, {2.0 / 3, 0, 0}, 0.7),
                                        poseWith(9, {1e5 / 3, 0, 0}, 1.3)};
  for (const TimedPose& given : poses) {
    const auto pose = poseAt(poses, given.stamp_ns);
    ASSERT_TRUE(pose);
    EXPECT_EQ(pose->matrix(), given.T_world_body.matrix());
  }
}

TEST(PoseAt, TheRightPairOfManyIsTaken) {
  // The body goes faster and faster: x = n^2 at n ms.
  std::vector<TimedPose> poses;
  for (int n = 0; n < 50; ++n) poses.push_back(poseWith(n * 1'000'000, {1.0 * n * n, 0, 0}, 0));
  for (int n = 0; n + 1 < 50; ++n) {
    const auto pose = poseAt(poses, kEpoch_ns + n * 1'000'000 + 500'000);
    ASSERT_TRUE(pose);
    EXPECT_NEAR(pose->translation().x(), n * n + n + 0.5, 1e-9);
  }
}

TEST(PoseAt, OutsideOfTheGivenTimesThereIsNone) {
  const std::vector<TimedPose> poses = {poseWith(0, {0, 0, 0}, 0), poseWith(10, {1, 0, 0}, 0)};
  EXPECT_FALSE(poseAt(poses, kEpoch_ns - 1));
  EXPECT_FALSE(poseAt(poses, kEpoch_ns + 11));
  EXPECT_FALSE(poseAt({}, kEpoch_ns));
  EXPECT_TRUE(poseAt(std::span(poses).first(1), kEpoch_ns));
}

}  // namespace
}  // namespace hydrabench

// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/simulation/odometry_drift.h"

#include <cmath>

#include <gtest/gtest.h>

#include "eval/simulation/trajectory.h"

namespace hydrabench {
namespace {

constexpr double kDegree = 3.14159265358979 / 180;

/// 100 m straight ahead in steps of 5 cm.
std::vector<StampedPose> straightDrive() {
  std::vector<StampedPose> poses;
  for (int i = 0; i <= 2000; ++i)
    poses.push_back({i * 100'000'000ll, cameraPose({0.05 * i, 0}, 0.8, 0, 0.1)});
  return poses;
}

TEST(OdometryDrift, SwitchedOffIsExact) {
  const std::vector<StampedPose> truth = straightDrive();
  const std::vector<Transform> poses = driftedPoses(truth, {}, 1);
  for (std::size_t i = 0; i < truth.size(); ++i) {
    EXPECT_TRUE(poses[i].isApprox(truth[i].T_world_camera, 1e-12));
  }
}

TEST(OdometryDrift, StartsExact) {
  OdometryDriftConfig config;
  config.translation_m_per_sqrt_m = 0.1;
  config.yaw_deg_per_sqrt_m = 5;
  EXPECT_TRUE(driftedPoses(straightDrive(), config, 1)
                  .front()
                  .isApprox(straightDrive().front().T_world_camera, 1e-12));
}

TEST(OdometryDrift, TranslationGrowsWithTheRootOfTheDistance) {
  OdometryDriftConfig config;
  config.translation_m_per_sqrt_m = 0.02;
  const std::vector<StampedPose> truth = straightDrive();
  double squares_25 = 0;
  double squares_100 = 0;
  constexpr int kRuns = 400;
  for (int seed = 0; seed < kRuns; ++seed) {
    const std::vector<Transform> poses =
        driftedPoses(truth, config, static_cast<std::uint64_t>(seed));
    squares_25 += std::pow(poses[500].translation().x() - 25, 2);
    squares_100 += std::pow(poses[2000].translation().x() - 100, 2);
  }
  // 0.02 sqrt(25) = 0.10 m and 0.02 sqrt(100) = 0.20 m; 400 runs know a deviation to 3.5 %.
  EXPECT_NEAR(std::sqrt(squares_25 / kRuns), 0.10, 0.015);
  EXPECT_NEAR(std::sqrt(squares_100 / kRuns), 0.20, 0.03);
}

TEST(OdometryDrift, YawGrowsWithTheRootOfTheDistanceAndRollAndPitchStay) {
  OdometryDriftConfig config;
  config.yaw_deg_per_sqrt_m = 0.5;
  const std::vector<StampedPose> truth = straightDrive();
  double squares = 0;
  constexpr int kRuns = 400;
  for (int seed = 0; seed < kRuns; ++seed) {
    const Transform last = driftedPoses(truth, config, static_cast<std::uint64_t>(seed)).back();
    const Eigen::Matrix3d turn = last.linear() * truth.back().T_world_camera.linear().transpose();
    squares += std::pow(std::atan2(turn(1, 0), turn(0, 0)), 2);
    EXPECT_NEAR(turn(2, 2), 1, 1e-9);
  }
  EXPECT_NEAR(std::sqrt(squares / kRuns), 5 * kDegree, 0.6 * kDegree);  // 0.5 deg * sqrt(100)
}

TEST(OdometryDrift, IsSmooth) {
  OdometryDriftConfig config;
  config.translation_m_per_sqrt_m = 0.05;
  const std::vector<Transform> poses = driftedPoses(straightDrive(), config, 3);
  for (std::size_t i = 1; i < poses.size(); ++i) {
    // The rate has deviation 0.05 / sqrt(2) per metre; a step is 5 cm.
    const double step = poses[i].translation().x() - poses[i - 1].translation().x();
    EXPECT_NEAR(step, 0.05, 0.05 * 5 * 0.05 / std::sqrt(2.0));
  }
}

TEST(OdometryDrift, IsAFunctionOfTheSeed) {
  OdometryDriftConfig config;
  config.translation_m_per_sqrt_m = 0.05;
  EXPECT_EQ(driftedPoses(straightDrive(), config, 3).back().matrix(),
            driftedPoses(straightDrive(), config, 3).back().matrix());
  EXPECT_NE(driftedPoses(straightDrive(), config, 3).back().matrix(),
            driftedPoses(straightDrive(), config, 4).back().matrix());
}

}  // namespace
}  // namespace hydrabench

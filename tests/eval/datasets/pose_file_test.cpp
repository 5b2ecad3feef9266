// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/datasets/pose_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/types/error.h"
#include "tests/support/temporary_folder.h"

namespace hydrabench {
namespace {

using ::testing::HasSubstr;

std::vector<StampedPose> readText13(const TemporaryFolder& folder, const std::string& text) {
  writeText(folder / "p.txt", text);
  return readPoses(folder / "p.txt");
}

TEST(PoseFile, MatricesReadBackBitEqual) {
  TemporaryFolder folder;
  StampedPose pose;
  pose.stamp_ns = 9007199254740993;  // has no double
  pose.T_world_camera.linear() =
      Eigen::AngleAxisd(1.0 / 3.0, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix();
  pose.T_world_camera.translation() = Eigen::Vector3d(1.0 / 3.0, -1e-17, 123456.789);
  writePoses(folder / "p.txt", {pose});
  const std::vector<StampedPose> read = readPoses(folder / "p.txt");
  ASSERT_EQ(read.size(), 1u);
  EXPECT_EQ(read[0].stamp_ns, pose.stamp_ns);
  EXPECT_EQ(read[0].T_world_camera.matrix(), pose.T_world_camera.matrix());
}

TEST(PoseFile, RotationsWithFewDigitsAreMadeOrthonormal) {
  TemporaryFolder folder;
  const auto poses = readText13(folder, "0 0.866 -0.5 0 1 0.5 0.866 0 2 0 0 1 3\n");
  const Eigen::Matrix3d R = poses.at(0).T_world_camera.linear();
  EXPECT_LT((R * R.transpose() - Eigen::Matrix3d::Identity()).norm(), 1e-14);
  EXPECT_NEAR(R(0, 0), 0.866, 1e-3);
}

TEST(PoseFile, TumLinesAreRead) {
  TemporaryFolder folder;
  const auto poses =
      readText13(folder, "# stamp tx ty tz qx qy qz qw\n1305031102.175304123 1 2 3 0 0 0.6 0.8\n");
  ASSERT_EQ(poses.size(), 1u);
  EXPECT_EQ(poses[0].stamp_ns, 1305031102175304123);  // more digits than a double has
  EXPECT_EQ(poses[0].T_world_camera.translation(), Eigen::Vector3d(1, 2, 3));
  // cos = 0.8^2 - 0.6^2 = 0.28, sin = 2 * 0.6 * 0.8 = 0.96
  EXPECT_TRUE((poses[0].T_world_camera.linear() * Eigen::Vector3d::UnitX())
                  .isApprox(Eigen::Vector3d(0.28, 0.96, 0), 1e-12));
}

TEST(PoseFile, LinesThatSayNothingElseAreRefused) {
  TemporaryFolder folder;
  const auto fault = [&](const std::string& text) {
    return messageOf<InputError>([&] { readText13(folder, text); });
  };
  EXPECT_THAT(fault("1 2 3\n"), HasSubstr("p.txt:1: 3 columns, expected 13"));
  EXPECT_THAT(fault("\n0.5 1 0 0 0 0 1 0 0 0 0 1 0\n"),
              HasSubstr("p.txt:2: expected a stamp in whole nanoseconds, found '0.5'"));
  EXPECT_THAT(fault("0 1 0 0 x 0 1 0 0 0 0 1 0\n"),
              HasSubstr("p.txt:1: expected a number, found 'x'"));
  EXPECT_THAT(fault("0.1 0 0 0 0 0 0 2\n"), HasSubstr("p.txt:1: quaternion of length 2"));
  EXPECT_THAT(fault("1.0 0 0 0 0 0 0 1\n1.0 0 0 0 0 0 0 1\n"),
              HasSubstr("p.txt:2: stamp 1000000000 ns does not come after the one before"));
}

}  // namespace
}  // namespace hydrabench

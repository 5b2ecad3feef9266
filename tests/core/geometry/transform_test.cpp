// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "core/geometry/transform.h"

#include <cmath>
#include <limits>
#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/geometry/camera.h"

namespace hydrabench {
namespace {

using ::testing::HasSubstr;

Eigen::Matrix3d rotationZ(double angle) {
  return Eigen::AngleAxisd(angle, Eigen::Vector3d::UnitZ()).toRotationMatrix();
}

TEST(RigidFromMatrix, ProjectsRoundedDigitsOntoARotation) {
  Eigen::Matrix4d matrix = Eigen::Matrix4d::Identity();
  matrix.topLeftCorner<3, 3>() = (rotationZ(0.3) * 1e4).array().round().matrix() / 1e4;
  matrix(0, 3) = 5;
  const auto transform = rigidFromMatrix(matrix);
  ASSERT_TRUE(transform);
  EXPECT_TRUE((transform->linear().transpose() * transform->linear()).isIdentity(1e-14));
  EXPECT_TRUE(transform->linear().isApprox(rotationZ(0.3), 1e-4));
  EXPECT_EQ(transform->translation(), Eigen::Vector3d(5, 0, 0));
}

TEST(RigidFromMatrix, SaysWhatIsWrong) {
  const auto faultOf = [](const Eigen::Matrix4d& matrix) {
    std::string fault;
    EXPECT_FALSE(rigidFromMatrix(matrix, &fault));
    return fault;
  };
  Eigen::Matrix4d matrix = Eigen::Matrix4d::Identity();
  matrix(1, 3) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THAT(faultOf(matrix), HasSubstr("not finite"));
  matrix = Eigen::Matrix4d::Identity();
  matrix(3, 0) = 1;
  EXPECT_THAT(faultOf(matrix), HasSubstr("bottom row (1, 0, 0, 1)"));
  matrix = Eigen::Matrix4d::Identity();
  matrix(0, 0) = 1.1;
  EXPECT_THAT(faultOf(matrix), HasSubstr("not orthonormal"));
  matrix = Eigen::Matrix4d::Identity();
  matrix(2, 2) = -1;
  EXPECT_THAT(faultOf(matrix), HasSubstr("mirrored"));
}

TEST(RotationAngle, IsTheAngleOfTheRotationBetween) {
  EXPECT_DOUBLE_EQ(rotationAngle(rotationZ(0.2), rotationZ(0.5)), 0.3);
  EXPECT_EQ(rotationAngle(rotationZ(0.2), rotationZ(0.2)), 0.0);
  EXPECT_NEAR(rotationAngle(rotationZ(0), rotationZ(std::numbers::pi)), std::numbers::pi, 1e-15);
}

TEST(RotationAngle, KeepsItsDigitsForTinyAngles) {
  EXPECT_NEAR(rotationAngle(Eigen::Matrix3d::Identity(), rotationZ(1e-9)), 1e-9, 1e-15);
}

TEST(Interpolate, MeetsBothEndsAndTheMiddle) {
  Transform from = Transform::Identity();
  Transform to = Transform::Identity();
  to.linear() = rotationZ(1.0);
  to.translation() = Eigen::Vector3d(2, 4, 6);
  EXPECT_TRUE(interpolate(from, to, 0).isApprox(from, 1e-15));
  EXPECT_TRUE(interpolate(from, to, 1).isApprox(to, 1e-15));
  const Transform middle = interpolate(from, to, 0.5);
  EXPECT_TRUE(middle.linear().isApprox(rotationZ(0.5), 1e-15));
  EXPECT_EQ(middle.translation(), Eigen::Vector3d(1, 2, 3));
}

TEST(LookAt, PointsTheOpticalAxisAtTheTargetWithWorldUpInTheImage) {
  const Transform T_world_camera = lookAt({1, 2, 1}, {4, 6, 1});
  const Eigen::Vector3d target = T_world_camera.inverse() * Eigen::Vector3d(4, 6, 1);
  EXPECT_TRUE(target.isApprox(Eigen::Vector3d(0, 0, 5), 1e-14));
  const Eigen::Vector3d above = T_world_camera.inverse() * Eigen::Vector3d(4, 6, 2);
  EXPECT_TRUE(above.isApprox(Eigen::Vector3d(0, -1, 5), 1e-14));  // y points down
  EXPECT_NEAR(T_world_camera.linear().determinant(), 1, 1e-14);
}

TEST(LookAt, IsDefinedStraightDown) {
  const Transform T_world_camera = lookAt({0, 0, 3}, {0, 0, 0});
  EXPECT_TRUE(T_world_camera.linear().col(2).isApprox(-Eigen::Vector3d::UnitZ()));
  EXPECT_NEAR(T_world_camera.linear().determinant(), 1, 1e-14);
}

TEST(Camera, ProjectsWhatItBackprojects) {
  const Camera camera{720, 480, 415.7, 415.7, 360, 240};
  const auto pixel = camera.project(camera.backproject(100, 50, 2.5));
  ASSERT_TRUE(pixel);
  EXPECT_NEAR(pixel->x(), 100, 1e-12);
  EXPECT_NEAR(pixel->y(), 50, 1e-12);
  EXPECT_EQ(camera.backproject(100, 50, 2.5).z(), 2.5);
  EXPECT_FALSE(camera.project({0, 0, 0}));
  EXPECT_FALSE(camera.project({0, 0, -1}));
}

TEST(Camera, SeesHalfAPixelBeyondTheOuterPixelCentres) {
  const Camera camera{4, 3, 1, 1, 0, 0};
  EXPECT_TRUE(camera.sees({-0.5, -0.5}));
  EXPECT_TRUE(camera.sees({3.49, 2.49}));
  EXPECT_FALSE(camera.sees({3.5, 0}));
  EXPECT_FALSE(camera.sees({0, 2.5}));
}

}  // namespace
}  // namespace hydrabench

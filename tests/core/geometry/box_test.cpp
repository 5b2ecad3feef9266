// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "core/geometry/box.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "core/geometry/transform.h"
#include "core/types/random.h"

namespace hydrabench {
namespace {

const Eigen::Vector3d kOnes = Eigen::Vector3d::Ones();

Aabb unitCube(const Eigen::Vector3d& low = Eigen::Vector3d::Zero()) {
  return {low, Eigen::Vector3d(low + kOnes)};
}

OrientedBox cubeAt(const Eigen::Vector3d& center, double yaw = 0) {
  OrientedBox box;
  box.T_world_box.translation() = center;
  box.T_world_box.linear() = Eigen::AngleAxisd(yaw, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  box.dimensions = kOnes;
  return box;
}

TEST(BoxIou, OfShiftedUnitCubesIsOneMinusDOverOnePlusD) {
  EXPECT_DOUBLE_EQ(boxIou(unitCube(), unitCube({0.25, 0, 0})), 3.0 / 5.0);
  EXPECT_DOUBLE_EQ(boxIou(unitCube(), unitCube({0, 0, 0.5})), 1.0 / 3.0);
  EXPECT_EQ(boxIou(unitCube(), unitCube()), 1);
}

TEST(BoxIou, OfBoxesApartOrTouchingIsZero) {
  EXPECT_EQ(boxIou(unitCube(), unitCube({2, 0, 0})), 0);
  EXPECT_EQ(boxIou(unitCube(), unitCube({1, 0, 0})), 0);
}

TEST(BoxIou, OfBoxesWithoutVolumeIsOneOnlyIfTheyAreEqual) {
  const Aabb plate(Eigen::Vector3d{0, 0, 0}, Eigen::Vector3d{1, 1, 0});
  EXPECT_EQ(boxIou(plate, plate), 1);
  EXPECT_EQ(boxIou(plate, Aabb(Eigen::Vector3d{0, 0, 0}, Eigen::Vector3d{1, 2, 0})), 0);
  EXPECT_EQ(boxIou(plate, unitCube()), 0);
  EXPECT_EQ(boxIou(Aabb(), unitCube()), 0);
}

TEST(HalfDiagonal, OfAUnitCubeIsHalfTheRootOfThree) {
  EXPECT_DOUBLE_EQ(halfDiagonal(unitCube()), std::sqrt(3.0) / 2);
  EXPECT_EQ(halfDiagonal(Aabb()), 0);
}

TEST(OrientedBoxIou, AgreesWithAlignedBoxes) {
  EXPECT_NEAR(orientedBoxIou(cubeAt({0, 0, 0}), cubeAt({0.25, 0, 0})), 3.0 / 5.0, 1e-15);
  EXPECT_NEAR(orientedBoxIou(cubeAt({0, 0, 0}), cubeAt({0.5, 0.5, 0.5})), 1.0 / 15.0, 1e-15);
  EXPECT_NEAR(orientedBoxIou(cubeAt({0, 0, 0}), cubeAt({2, 0, 0})), 0, 1e-15);
  EXPECT_NEAR(orientedBoxIou(cubeAt({0, 0, 0}), cubeAt({1, 0, 0})), 0, 1e-12);
}

TEST(OrientedBoxIou, OfACubeAndItselfTurnedByAnEighthIsThatOfTheOctagon) {
  // Two unit squares at 45 degrees share a regular octagon of area 2 (sqrt 2 - 1).
  const double shared = 2 * (std::numbers::sqrt2 - 1);
  EXPECT_NEAR(orientedBoxIou(cubeAt({3, -2, 1}), cubeAt({3, -2, 1}, std::numbers::pi / 4)),
              shared / (2 - shared), 1e-14);
}

TEST(OrientedBoxIou, CountsCoincidingFacesOnce) {
  EXPECT_EQ(orientedBoxIou(cubeAt({1, 2, 3}, 0.3), cubeAt({1, 2, 3}, 0.3)), 1);
  // The same cube, its axes named differently: all six faces coincide up to rounding.
  EXPECT_NEAR(orientedBoxIou(cubeAt({1, 2, 3}, 0.3), cubeAt({1, 2, 3}, 0.3 + std::numbers::pi / 2)),
              1, 1e-12);
  OrientedBox half = cubeAt({0.25, 0, 0});
  half.dimensions.x() = 0.5;
  EXPECT_NEAR(orientedBoxIou(cubeAt({0, 0, 0}), half), 0.5, 1e-15);
}

TEST(OrientedBoxIou, OfABoxInsideAnotherIsTheRatioOfVolumes) {
  OrientedBox small = cubeAt({0.1, 0, 0}, 0.7);
  small.dimensions = {0.1, 0.2, 0.3};
  EXPECT_NEAR(orientedBoxIou(cubeAt({0, 0, 0}), small), 0.006, 1e-15);
  EXPECT_NEAR(orientedBoxIou(small, cubeAt({0, 0, 0})), 0.006, 1e-15);
}

TEST(OrientedBoxIou, IsSymmetricAndUnchangedByRigidMotion) {
  for (std::uint64_t i = 0; i < 200; ++i) {
    Random random(1, i);
    const auto draw = [&] {
      OrientedBox box;
      box.T_world_box.linear() =
          Eigen::Quaterniond(random.normal(), random.normal(), random.normal(), random.normal())
              .normalized()
              .toRotationMatrix();
      box.T_world_box.translation() =
          Eigen::Vector3d(random.normal(), random.normal(), random.normal()) * 0.3;
      box.dimensions = {random.uniform(0.2, 1), random.uniform(0.2, 1), random.uniform(0.2, 1)};
      return box;
    };
    OrientedBox a = draw();
    OrientedBox b = draw();
    const double iou = orientedBoxIou(a, b);
    EXPECT_NEAR(orientedBoxIou(b, a), iou, 1e-12);
    const Transform motion = draw().T_world_box;
    a.T_world_box = motion * a.T_world_box;
    b.T_world_box = motion * b.T_world_box;
    EXPECT_NEAR(orientedBoxIou(a, b), iou, 1e-12);
  }
}

TEST(OrientedBoxIou, AgreesWithCountingPoints) {
  Random random(7);
  OrientedBox a = cubeAt({0, 0, 0}, 0.4);
  OrientedBox b = cubeAt({0.2, -0.1, 0.15});
  b.T_world_box.linear() =
      Eigen::AngleAxisd(0.9, Eigen::Vector3d(1, 2, -1).normalized()).toRotationMatrix();
  int in_both = 0;
  int in_any = 0;
  const auto contains = [](const OrientedBox& box, const Eigen::Vector3d& p) {
    return ((box.T_world_box.inverse() * p).array().abs() <= 0.5 * box.dimensions.array()).all();
  };
  for (int i = 0; i < 200000; ++i) {
    const Eigen::Vector3d p(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
    const bool in_a = contains(a, p);
    const bool in_b = contains(b, p);
    in_both += in_a && in_b;
    in_any += in_a || in_b;
  }
  EXPECT_NEAR(orientedBoxIou(a, b), static_cast<double>(in_both) / in_any, 0.01);
}

}  // namespace
}  // namespace hydrabench

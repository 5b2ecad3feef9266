// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "metrics/oriented_box.h"

#include <gtest/gtest.h>

#include "core/geometry/mesh_repair.h"
#include "tests/metrics/shapes.h"

namespace hydrabench {
namespace {

TEST(ObjectOrientedBox, OfATurnedCuboidIsTheCuboid) {
  const Transform turn = Eigen::Translation3d(3, -2, 1) *
                         Eigen::AngleAxisd(0.6, Eigen::Vector3d(1, 1, 2).normalized());
  const OrientedBox box = objectOrientedBox(transformed(turn, cuboid({0, 0, 0}, {1, 0.3, 0.5})));
  EXPECT_NEAR(box.volume(), 0.15, 1e-6);
  EXPECT_TRUE(
      box.T_world_box.translation().isApprox(turn * Eigen::Vector3d(0.5, 0.15, 0.25), 1e-6));
}

TEST(ObjectOrientedBox, HoldsEveryVertex) {
  const Mesh mesh = potato({1, 2, 3}, 0.5, 4);
  const OrientedBox box = objectOrientedBox(mesh);
  for (const Eigen::Vector3d& vertex : mesh.vertices) {
    const Eigen::Vector3d local = box.T_world_box.inverse() * vertex;
    ASSERT_TRUE((local.array().abs() <= box.dimensions.array() / 2 + 1e-9).all());
  }
}

TEST(ObjectOrientedBox, IsHardlyLargerThanThatOfAllVertices) {
  for (int i = 0; i < 3; ++i) {
    const Mesh mesh = transformed(Transform(Eigen::AngleAxisd(0.5 * i, Eigen::Vector3d::UnitY())),
                                  potato({0, 0, 0}, 0.5, 4, i));
    EXPECT_LT(objectOrientedBox(mesh).volume(), 1.01 * smallestBox(mesh).volume());
  }
}

TEST(ObjectOrientedBox, OfAFlatMeshIsItsAlignedBox) {
  Mesh sheet;
  sheet.vertices = {{0, 0, 0}, {1, 0, 1}, {1, 1, 1}, {0, 1, 0}};
  sheet.faces = {{0, 1, 2}, {0, 2, 3}};
  EXPECT_TRUE(objectOrientedBox(sheet).dimensions.isApprox(Eigen::Vector3d(1, 1, 1)));
}

TEST(ObjectOrientedBox, IgnoresStrayVertices) {
  Mesh mesh = unitCube();
  mesh.vertices.emplace_back(50, 0, 0);
  EXPECT_NEAR(objectOrientedBox(mesh).volume(), 1, 1e-9);
}

}  // namespace
}  // namespace hydrabench

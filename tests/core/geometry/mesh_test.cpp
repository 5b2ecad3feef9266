// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "core/geometry/mesh.h"

#include <numbers>

#include <gtest/gtest.h>

#include "core/geometry/mesh_topology.h"

namespace hydrabench {
namespace {

const Aabb kBox(Eigen::Vector3d(1, 2, 3), Eigen::Vector3d(3, 5, 7));  // 2 x 3 x 4

TEST(BoxMesh, HasTheVolumeAndAreaOfTheBoxAndFacesOutwards) {
  const Mesh mesh = boxMesh(kBox);
  EXPECT_EQ(mesh.vertices.size(), 8u);
  EXPECT_EQ(mesh.faces.size(), 12u);
  EXPECT_DOUBLE_EQ(signedVolume(mesh), 24);
  EXPECT_DOUBLE_EQ(surfaceArea(mesh), 2 * (6 + 8 + 12));
  EXPECT_TRUE(analyzeTopology(mesh).watertight());
  EXPECT_EQ(bounds(mesh).min(), kBox.min());
  EXPECT_EQ(bounds(mesh).max(), kBox.max());
}

TEST(SphereMesh, ApproachesTheVolumeOfTheSphereFromInside) {
  const double exact = 4.0 / 3.0 * std::numbers::pi * 8;
  double last_error = exact;
  for (int level = 0; level <= 5; ++level) {
    const Mesh mesh = sphereMesh({5, 5, 5}, 2, level);
    EXPECT_EQ(mesh.faces.size(), 20u << (2 * level));
    EXPECT_TRUE(analyzeTopology(mesh).watertight());
    const double error = exact - signedVolume(mesh);
    EXPECT_GT(error, 0);
    EXPECT_LT(error, level == 0 ? exact : 0.36 * last_error);
    last_error = error;
  }
  EXPECT_LT(last_error / exact, 2e-3);
}

TEST(SphereMesh, HasItsVerticesOnTheSphere) {
  for (const Eigen::Vector3d& v : sphereMesh({1, 2, 3}, 0.5, 3).vertices) {
    EXPECT_NEAR((v - Eigen::Vector3d(1, 2, 3)).norm(), 0.5, 1e-15);
  }
}

TEST(SignedVolume, KeepsItsDigitsFarFromTheOrigin) {
  Transform far = Transform::Identity();
  far.translation() = Eigen::Vector3d{1e5, -2e5, 3e5};
  EXPECT_NEAR(signedVolume(transformed(far, boxMesh(kBox))), 24, 1e-8);
}

TEST(SignedVolume, IsNegativeWhereTheMeshIsInsideOut) {
  Mesh mesh = boxMesh(kBox);
  for (Eigen::Vector3i& face : mesh.faces) std::swap(face[0], face[1]);
  EXPECT_DOUBLE_EQ(signedVolume(mesh), -24);
}

TEST(Mesh, WithoutFacesHasNoAreaVolumeOrBox) {
  EXPECT_EQ(surfaceArea(Mesh()), 0);
  EXPECT_EQ(signedVolume(Mesh()), 0);
  EXPECT_TRUE(bounds(Mesh()).isEmpty());
}

TEST(Scaled, MultipliesTheVolumeByTheCube) {
  EXPECT_DOUBLE_EQ(signedVolume(scaled(0.5, boxMesh(kBox))), 3);
}

TEST(Append, ShiftsIndicesAndKeepsColoursIfBothHaveThem) {
  Mesh red = boxMesh(kBox);
  red.colors.assign(8, {255, 0, 0});
  Mesh whole;
  append(red, whole);
  EXPECT_EQ(whole.colors.size(), 8u);
  append(red, whole);
  EXPECT_EQ(whole.vertices.size(), 16u);
  EXPECT_EQ(whole.colors.size(), 16u);
  EXPECT_EQ(whole.faces[12], Eigen::Vector3i(red.faces[0].array() + 8));
  EXPECT_DOUBLE_EQ(signedVolume(whole), 48);
  append(boxMesh(kBox), whole);
  EXPECT_TRUE(whole.colors.empty());
  append(red, whole);
  EXPECT_TRUE(whole.colors.empty());
}

TEST(RoundToFloat, LeavesFloatsInEveryPlace) {
  // All counts up to a few vectors of the CPU: compilers treat the last vertices apart.
  for (std::size_t count = 1; count < 40; ++count) {
    Mesh mesh;
    mesh.vertices.assign(count, Eigen::Vector3d(0.1, 0.2, 0.3));
    roundToFloat(mesh);
    for (const Eigen::Vector3d& v : mesh.vertices) {
      EXPECT_EQ(v, Eigen::Vector3d(double{0.1f}, double{0.2f}, double{0.3f}));
    }
  }
}

}  // namespace
}  // namespace hydrabench

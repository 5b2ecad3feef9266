// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/report/html/packed_mesh.h"

#include <gtest/gtest.h>

namespace hydrabench {
namespace {

/// The corners of every face, whatever the order of the vertices.
double largestStep(const Mesh& a, const Mesh& b) {
  double largest = 0;
  for (std::size_t f = 0; f < a.faces.size(); ++f) {
    for (int k = 0; k < 3; ++k) {
      const auto& from = a.vertices[static_cast<std::size_t>(a.faces[f][k])];
      const auto& to = b.vertices[static_cast<std::size_t>(b.faces[f][k])];
      largest = std::max(largest, (from - to).cwiseAbs().maxCoeff());
    }
  }
  return largest;
}

TEST(PackedMesh, ComesBackWithinHalfAStepOfItsBox) {
  const Mesh sphere = sphereMesh({3, -2, 1}, 0.7, 3);
  const Mesh back = unpackMesh(packMesh(sphere));
  ASSERT_EQ(back.faces.size(), sphere.faces.size());
  EXPECT_LE(largestStep(sphere, back), 0.5001 * 1.4 / 65535);
  EXPECT_GT(largestStep(sphere, back), 0);
}

TEST(PackedMesh, KeepsColorsExactlyAndWithTheirVertices) {
  Mesh box = boxMesh(Aabb(Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(1, 2, 3)));
  for (std::size_t i = 0; i < box.vertices.size(); ++i) {
    box.colors.push_back(
        {static_cast<std::uint8_t>(31 * i), static_cast<std::uint8_t>(255 - i), 7});
  }
  const Mesh back = unpackMesh(packMesh(box));
  for (std::size_t f = 0; f < box.faces.size(); ++f) {
    for (int k = 0; k < 3; ++k) {
      EXPECT_EQ(back.colors[static_cast<std::size_t>(back.faces[f][k])],
                box.colors[static_cast<std::size_t>(box.faces[f][k])]);
    }
  }
}

TEST(PackedMesh, HasWideIndicesWhereTwoBytesAreTooFew) {
  EXPECT_FALSE(packMesh(sphereMesh({0, 0, 0}, 1, 2)).wide);
  const Mesh large = sphereMesh({0, 0, 0}, 1, 7);  // 163842 vertices
  const PackedMesh packed = packMesh(large);
  EXPECT_TRUE(packed.wide);
  EXPECT_LE(largestStep(large, unpackMesh(packed)), 0.5001 * 2 / 65535);
}

TEST(PackedMesh, DropsVerticesThatNoFaceUses) {
  Mesh box = boxMesh(Aabb(Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(1, 1, 1)));
  box.vertices.emplace_back(100, 100, 100);
  const PackedMesh packed = packMesh(box);
  EXPECT_EQ(packed.vertices, 8u);
  EXPECT_EQ(packed.size, Eigen::Vector3d(1, 1, 1));
}

TEST(PackedMesh, TakesFlatAndEmptyMeshes) {
  Mesh sheet;
  sheet.vertices = {{0, 0, 2}, {1, 0, 2}, {0, 1, 2}};
  sheet.faces = {{0, 1, 2}};
  EXPECT_LE(largestStep(sheet, unpackMesh(packMesh(sheet))), 1e-4);
  EXPECT_TRUE(unpackMesh(packMesh(Mesh())).empty());
}

}  // namespace
}  // namespace hydrabench

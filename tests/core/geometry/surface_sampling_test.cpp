// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "core/geometry/surface_sampling.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

namespace hydrabench {
namespace {

TEST(SampleSurface, DrawsFromFacesInProportionToTheirArea) {
  // 2 x 3 x 4: the six sides have areas 12 12 8 8 6 6 of 52.
  const Mesh box = boxMesh(Aabb(Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(2, 3, 4)));
  constexpr int kCount = 52000;
  const SurfaceSamples samples = sampleSurface(box, kCount, 1);
  ASSERT_EQ(samples.points.size(), static_cast<std::size_t>(kCount));
  int on_bottom = 0;
  int on_left = 0;
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& p : samples.points) {
    on_bottom += p.z() == 0;
    on_left += p.x() == 0;
    mean += p / kCount;
  }
  EXPECT_NEAR(on_bottom, 6000, 5 * std::sqrt(6000.0));
  EXPECT_NEAR(on_left, 12000, 5 * std::sqrt(12000.0));
  EXPECT_TRUE(mean.isApprox(Eigen::Vector3d(1, 1.5, 2), 0.02));
}

TEST(SampleSurface, IsUniformInsideATriangle) {
  Mesh triangle;
  triangle.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  triangle.faces = {{0, 1, 2}};
  constexpr int kCount = 40000;
  int in_inner_quarter = 0;
  for (const Eigen::Vector3d& p : sampleSurface(triangle, kCount, 2).points) {
    EXPECT_GE(p.minCoeff(), 0);
    EXPECT_LE(p.x() + p.y(), 1 + 1e-15);
    in_inner_quarter += p.x() < 0.5 && p.y() < 0.5 && p.x() + p.y() > 0.5;  // the medial triangle
  }
  EXPECT_NEAR(in_inner_quarter, kCount / 4, 5 * std::sqrt(kCount * 3.0 / 16));
}

TEST(SampleSurface, LeavesOutFacesWithoutArea) {
  Mesh mesh;
  mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {5, 5, 5}};
  mesh.faces = {{3, 3, 3}, {0, 1, 2}, {0, 3, 3}};
  for (const std::uint32_t face : sampleSurface(mesh, 1000, 3).faces) EXPECT_EQ(face, 1u);
  mesh.faces = {{3, 3, 3}};
  EXPECT_TRUE(sampleSurface(mesh, 10, 3).points.empty());
  EXPECT_TRUE(sampleSurface(Mesh(), 10, 3).points.empty());
}

TEST(SampleSurface, IsAFunctionOfTheSeed) {
  const Mesh sphere = sphereMesh({0, 0, 0}, 1, 2);
  EXPECT_EQ(sampleSurface(sphere, 50, 4).points, sampleSurface(sphere, 50, 4).points);
  EXPECT_NE(sampleSurface(sphere, 50, 4).points, sampleSurface(sphere, 50, 5).points);
  // More samples begin with the same ones.
  const auto many = sampleSurface(sphere, 80, 4).points;
  EXPECT_TRUE(
      std::equal(many.begin(), many.begin() + 50, sampleSurface(sphere, 50, 4).points.begin()));
}

}  // namespace
}  // namespace hydrabench

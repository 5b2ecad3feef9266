// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "core/geometry/mesh_repair.h"

#include <algorithm>
#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/geometry/mesh_topology.h"
#include "core/geometry/raycaster.h"
#include "core/types/error.h"

namespace hydrabench {
namespace {

Mesh cubeAt(const Eigen::Vector3d& low, double size = 1) {
  return boxMesh(Aabb(low, Eigen::Vector3d(low.array() + size)));
}

/// A sphere that has lost its faces above a height.
Mesh bowl(double height) {
  Mesh mesh = sphereMesh({0, 0, 0}, 1, 3);
  std::erase_if(mesh.faces, [&](const Eigen::Vector3i& face) {
    return std::any_of(face.begin(), face.end(), [&](int v) {
      return mesh.vertices[static_cast<std::size_t>(v)].z() > height;
    });
  });
  return mesh;
}

TEST(WithHolesFilled, ClosesASphereAndAlmostRestoresItsVolume) {
  const Mesh open = bowl(0.8);
  ASSERT_FALSE(analyzeTopology(open).watertight());
  const Mesh closed = withHolesFilled(open);
  EXPECT_TRUE(analyzeTopology(closed).watertight());
  EXPECT_NEAR(signedVolume(closed) / signedVolume(sphereMesh({0, 0, 0}, 1, 3)), 1, 0.05);
}

TEST(WithHolesFilled, OrientsASoupFirst) {
  Mesh soup;
  const Mesh open = bowl(0.8);
  for (const Eigen::Vector3i& face : open.faces) {
    const int first = static_cast<int>(soup.vertices.size());
    for (const int corner : face)
      soup.vertices.push_back(open.vertices[static_cast<std::size_t>(corner)]);
    soup.faces.emplace_back(first, first + 1, first + 2);
    if (soup.faces.size() % 3 == 0) std::swap(soup.faces.back()[0], soup.faces.back()[1]);
  }
  EXPECT_TRUE(analyzeTopology(withHolesFilled(soup)).watertight());
}

TEST(AlphaWrapped, IsWatertightAndEnclosesAnOpenMesh) {
  const Mesh open = bowl(0.8);
  const Mesh wrap = alphaWrapped(open, 0.8, 0.02);
  EXPECT_TRUE(analyzeTopology(wrap).watertight());
  EXPECT_GT(signedVolume(wrap), 0.9 * 4.0 / 3.0 * std::numbers::pi);
  Raycaster surface;
  surface.add(wrap);
  surface.commit();
  for (const Eigen::Vector3i& face : open.faces) {
    EXPECT_LT(surface.nearest(open.vertices[static_cast<std::size_t>(face[0])]).distance, 0.05);
  }
}

TEST(SmallestBox, RecoversATurnedCuboid) {
  Transform turned = Transform::Identity();
  turned.linear() =
      Eigen::AngleAxisd(0.6, Eigen::Vector3d(1, 2, -0.5).normalized()).toRotationMatrix();
  turned.translation() = Eigen::Vector3d{10, -4, 2};
  const Mesh mesh =
      transformed(turned, boxMesh(Aabb(Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(1, 2, 3))));
  const OrientedBox box = smallestBox(mesh);
  EXPECT_NEAR(box.volume(), 6, 1e-6);
  EXPECT_NEAR(box.T_world_box.linear().determinant(), 1, 1e-9);
  EXPECT_TRUE((box.T_world_box.linear().transpose() * box.T_world_box.linear()).isIdentity(1e-9));
  OrientedBox expected;
  expected.T_world_box = turned;
  expected.T_world_box.translation() = turned * Eigen::Vector3d(0.5, 1, 1.5);
  expected.dimensions = {1, 2, 3};
  EXPECT_NEAR(orientedBoxIou(box, expected), 1, 1e-6);
}

TEST(SmallestBox, IsTheSameForTheSameMesh) {
  const Mesh mesh = sphereMesh({1, 2, 3}, 0.5, 2);
  const OrientedBox first = smallestBox(mesh);
  const OrientedBox second = smallestBox(mesh);
  EXPECT_EQ(first.T_world_box.matrix(), second.T_world_box.matrix());
  EXPECT_EQ(first.dimensions, second.dimensions);
}

TEST(SmallestBox, RefusesWhatSpansNoVolume) {
  Mesh flat;
  flat.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {0.3, 0.2, 0}};
  EXPECT_THROW(smallestBox(flat), InputError);
  EXPECT_THROW(smallestBox(Mesh()), InputError);
}

TEST(IntersectionVolume, OfShiftedCubesIsTheirCommonBox) {
  EXPECT_NEAR(intersectionVolume(cubeAt({0, 0, 0}), cubeAt({0.25, 0.5, 0.1})), 0.75 * 0.5 * 0.9,
              1e-12);
  EXPECT_NEAR(intersectionVolume(cubeAt({0, 0, 0}), cubeAt({0.25, 0.25, 0.25}, 0.5)), 0.125, 1e-12);
  EXPECT_EQ(intersectionVolume(cubeAt({0, 0, 0}), cubeAt({3, 0, 0})), 0);
  EXPECT_NEAR(intersectionVolume(cubeAt({0, 0, 0}), cubeAt({0, 0, 0})), 1, 1e-12);
}

TEST(IntersectionVolume, OfSpheresIsTheLens) {
  // Two unit spheres a distance of 1 apart: pi (4 + 1) (2 - 1)^2 / 12 = 5 pi / 12.
  const double volume =
      intersectionVolume(sphereMesh({0, 0, 0}, 1, 5), sphereMesh({1, 0, 0}, 1, 5));
  EXPECT_NEAR(volume / (5 * std::numbers::pi / 12), 1, 5e-3);
}

TEST(IntersectionVolume, TakesAnInsideOutSolidTheRightWayRound) {
  Mesh cube = cubeAt({0.5, 0, 0});
  for (Eigen::Vector3i& face : cube.faces) std::swap(face[0], face[1]);
  EXPECT_NEAR(intersectionVolume(cubeAt({0, 0, 0}), cube), 0.5, 1e-12);
}

TEST(IntersectionVolume, RefusesAnOpenMesh) {
  EXPECT_THROW(intersectionVolume(bowl(0.5), cubeAt({0, 0, 0})), InputError);
}

}  // namespace
}  // namespace hydrabench

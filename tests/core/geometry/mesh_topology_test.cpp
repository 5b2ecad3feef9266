// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "core/geometry/mesh_topology.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "core/geometry/raycaster.h"

namespace hydrabench {
namespace {

Mesh unitCube() { return boxMesh(Aabb(Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(1, 1, 1))); }

/// The same triangles, each with corners of its own.
Mesh soupOf(const Mesh& mesh) {
  Mesh soup;
  for (const Eigen::Vector3i& face : mesh.faces) {
    const int first = static_cast<int>(soup.vertices.size());
    for (const int corner : face)
      soup.vertices.push_back(mesh.vertices[static_cast<std::size_t>(corner)]);
    soup.faces.emplace_back(first, first + 1, first + 2);
  }
  return soup;
}

/// Two cubes that share an edge (so that four faces meet there) and, at another corner, a third one
/// that touches in a point.
Mesh touchingCubes() {
  Mesh mesh = unitCube();
  append(boxMesh(Aabb(Eigen::Vector3d(1, 1, 0), Eigen::Vector3d(2, 2, 1))), mesh);
  append(boxMesh(Aabb(Eigen::Vector3d(-1, -1, -1), Eigen::Vector3d(0, 0, 0))), mesh);
  return mesh;
}

TEST(AnalyzeTopology, SeesAClosedMeshEvenAsASoup) {
  for (const Mesh& mesh : {unitCube(), soupOf(unitCube()), soupOf(sphereMesh({0, 0, 0}, 1, 3))}) {
    const MeshTopology topology = analyzeTopology(mesh);
    EXPECT_TRUE(topology.watertight());
    EXPECT_EQ(topology.components, 1u);
    EXPECT_EQ(topology.boundary_length, 0);
  }
}

TEST(AnalyzeTopology, MeasuresTheBorderOfAHole) {
  Mesh cube = unitCube();
  cube.faces.pop_back();
  const MeshTopology topology = analyzeTopology(cube);
  EXPECT_FALSE(topology.watertight());
  EXPECT_EQ(topology.boundary_edges, 3u);
  EXPECT_DOUBLE_EQ(topology.boundary_length, 2 + std::numbers::sqrt2);
}

TEST(AnalyzeTopology, NoticesAFaceTheWrongWayRound) {
  Mesh cube = unitCube();
  std::swap(cube.faces[3][0], cube.faces[3][1]);
  const MeshTopology topology = analyzeTopology(cube);
  EXPECT_EQ(topology.misoriented_edges, 3u);
  EXPECT_EQ(topology.boundary_edges, 0u);
  EXPECT_FALSE(topology.watertight());
}

TEST(AnalyzeTopology, NoticesEdgesOfManyFacesAndCountsComponents) {
  const MeshTopology topology = analyzeTopology(touchingCubes());
  EXPECT_EQ(topology.nonmanifold_edges, 1u);
  EXPECT_EQ(topology.components, 2u);  // a point connects nothing
  EXPECT_FALSE(topology.watertight());
}

TEST(AnalyzeTopology, IgnoresDegenerateFaces) {
  Mesh cube = unitCube();
  cube.faces.emplace_back(0, 0, 1);
  EXPECT_TRUE(analyzeTopology(cube).watertight());
  EXPECT_EQ(analyzeTopology(Mesh()).components, 0u);
  EXPECT_FALSE(analyzeTopology(Mesh()).watertight());
}

TEST(Welded, MergesASoupAndDropsWhatNobodyUses) {
  Mesh soup = soupOf(unitCube());
  soup.vertices.emplace_back(9, 9, 9);
  soup.faces.emplace_back(0, 0, 1);
  soup.colors.assign(soup.vertices.size(), {1, 2, 3});
  const Mesh mesh = welded(soup);
  EXPECT_EQ(mesh.vertices.size(), 8u);
  EXPECT_EQ(mesh.colors.size(), 8u);
  EXPECT_EQ(mesh.faces.size(), 12u);
  EXPECT_DOUBLE_EQ(signedVolume(mesh), 1);
}

TEST(Welded, TakesPlusAndMinusZeroAsOnePlace) {
  Mesh mesh;
  mesh.vertices = {{0.0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-0.0, 0, 0}, {-1, 0, 0}};
  mesh.faces = {{0, 1, 2}, {3, 2, 4}};
  EXPECT_EQ(welded(mesh).vertices.size(), 4u);
}

double farthest(const Mesh& from, const Mesh& to) {
  Raycaster surface;
  surface.add(to);
  surface.commit();
  double distance = 0;
  for (const Eigen::Vector3d& v : from.vertices)
    distance = std::max(distance, surface.nearest(v).distance);
  return distance;
}

TEST(Decimated, KeepsASphereClosedAndCloseToItself) {
  const Mesh sphere = sphereMesh({100, -50, 20}, 0.5, 5);
  const Mesh coarse = decimated(sphere, 2000, 1.0);
  EXPECT_LE(coarse.faces.size(), 2000u);
  EXPECT_GE(coarse.faces.size(), 1900u);
  EXPECT_TRUE(analyzeTopology(coarse).watertight());
  EXPECT_LT(farthest(sphere, coarse), 0.004);
  EXPECT_NEAR(signedVolume(coarse) / signedVolume(sphere), 1, 0.01);
}

TEST(Decimated, StopsAtTheErrorBound) {
  const Mesh sphere = sphereMesh({0, 0, 0}, 0.5, 4);
  const Mesh fine = decimated(sphere, 4, 0.002);
  const Mesh coarse = decimated(sphere, 4, 0.02);
  EXPECT_LT(coarse.faces.size(), fine.faces.size());
  EXPECT_LT(fine.faces.size(), sphere.faces.size());
  EXPECT_LT(farthest(sphere, fine), 0.008);
  EXPECT_LT(farthest(sphere, coarse), 0.08);
  EXPECT_TRUE(analyzeTopology(coarse).watertight());
}

/// A cube whose sides are grids of 2 n^2 triangles.
Mesh fineCube(int n) {
  Mesh mesh;
  for (int axis = 0; axis < 3; ++axis) {
    for (const int side : {0, 1}) {
      for (int i = 0; i < n * n; ++i) {
        const auto at = [&](int du, int dv) {
          Eigen::Vector3d p;
          p[axis] = side;
          p[(axis + 1) % 3] = static_cast<double>(i % n + du) / n;
          p[(axis + 2) % 3] = static_cast<double>(i / n + dv) / n;
          mesh.vertices.push_back(p);
          return static_cast<int>(mesh.vertices.size()) - 1;
        };
        const int a = at(0, 0);
        const int b = at(1, 0);
        const int c = at(1, 1);
        const int d = at(0, 1);
        mesh.faces.emplace_back(side ? Eigen::Vector3i(a, b, c) : Eigen::Vector3i(a, c, b));
        mesh.faces.emplace_back(side ? Eigen::Vector3i(a, c, d) : Eigen::Vector3i(a, d, c));
      }
    }
  }
  return mesh;
}

TEST(Decimated, BringsAFineCubeDownToItsTwelveFaces) {
  const Mesh cube = fineCube(8);
  ASSERT_TRUE(analyzeTopology(cube).watertight());
  const Mesh coarse = decimated(cube, 12, 1e-6);
  EXPECT_EQ(coarse.faces.size(), 12u);
  EXPECT_NEAR(signedVolume(coarse), 1, 1e-12);
  EXPECT_TRUE(analyzeTopology(coarse).watertight());
}

TEST(Decimated, KeepsTheBorderOfAnOpenMesh) {
  Mesh sheet;
  for (int i = 0; i < 400; ++i) sheet.vertices.emplace_back(i % 20, i / 20, 0);
  for (int i = 0; i < 380; ++i) {
    if (i % 20 == 19) continue;
    sheet.faces.emplace_back(i, i + 1, i + 21);
    sheet.faces.emplace_back(i, i + 21, i + 20);
  }
  const Mesh coarse = decimated(sheet, 2, 1e-6);
  EXPECT_LE(coarse.faces.size(), 4u);
  EXPECT_NEAR(surfaceArea(coarse), 19 * 19, 1e-9);
}

TEST(Decimated, LeavesSolidsThatTouchClosed) {
  Mesh mesh = scaled(1.0, fineCube(6));
  Transform shift = Transform::Identity();
  shift.translation() = Eigen::Vector3d{1, 1, 0};  // an edge in common
  append(transformed(shift, fineCube(6)), mesh);
  shift.translation() = Eigen::Vector3d{-1, -1, -1};  // a corner in common
  append(transformed(shift, fineCube(6)), mesh);
  const Mesh coarse = decimated(mesh, 60, 1e-6);
  EXPECT_LT(coarse.faces.size(), mesh.faces.size() / 4);
  EXPECT_NEAR(signedVolume(coarse), 3, 1e-12);
  EXPECT_EQ(analyzeTopology(coarse).boundary_edges, 0u);
  EXPECT_EQ(analyzeTopology(coarse).misoriented_edges, 0u);
}

TEST(Decimated, KeepsTwoOverlappingSpheresWatertight) {
  Mesh mesh = sphereMesh({0, 0, 0}, 0.5, 4);
  append(sphereMesh({0.4, 0, 0}, 0.5, 4), mesh);
  const Mesh coarse = decimated(mesh, 1500, 1.0);
  EXPECT_TRUE(analyzeTopology(coarse).watertight());
  EXPECT_LE(coarse.faces.size(), 1500u);
}

TEST(Decimated, TakesColoursAlong) {
  Mesh sphere = sphereMesh({0, 0, 0}, 1, 3);
  for (const Eigen::Vector3d& v : sphere.vertices)
    sphere.colors.push_back({static_cast<std::uint8_t>(v.z() > 0 ? 255 : 0), 0, 0});
  const Mesh coarse = decimated(sphere, 300, 1.0);
  ASSERT_EQ(coarse.colors.size(), coarse.vertices.size());
  for (std::size_t i = 0; i < coarse.vertices.size(); ++i) {
    EXPECT_EQ(coarse.colors[i].r, coarse.vertices[i].z() > 0 ? 255 : 0);
  }
}

TEST(Decimated, LeavesASmallMeshAlone) {
  EXPECT_EQ(decimated(unitCube(), 100, 1.0).faces.size(), 12u);
  EXPECT_TRUE(decimated(Mesh(), 100, 1.0).empty());
}

TEST(ConnectedComponents, ComeLargestFirstAndJoinOverPoints) {
  Mesh mesh = scaled(0.5, unitCube());
  append(touchingCubes(), mesh);  // touches the small one at the origin's corner: move that away
  for (std::size_t i = 0; i < 8; ++i) mesh.vertices[i].x() += 10;
  mesh.colors.assign(mesh.vertices.size(), {1, 2, 3});
  const auto components = connectedComponents(soupOf(mesh));
  ASSERT_EQ(components.size(), 2u);
  EXPECT_DOUBLE_EQ(signedVolume(components[0]), 3);
  EXPECT_DOUBLE_EQ(signedVolume(components[1]), 0.125);
  EXPECT_EQ(connectedComponents(mesh)[1].vertices.size(), 8u);
  EXPECT_EQ(connectedComponents(mesh)[1].colors.size(), 8u);
  EXPECT_TRUE(connectedComponents(Mesh()).empty());
}

}  // namespace
}  // namespace hydrabench

// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "core/shape/sdf_mesher.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <set>
#include <vector>

#include <gtest/gtest.h>

#include "core/geometry/mesh_topology.h"
#include "core/parallel/parallel_for.h"

namespace hydrabench {
namespace {

using Eigen::Vector3f;

template <typename Distance>
SdfField fieldOf(const Distance& distance) {
  return [distance](std::span<const Vector3f> points, std::span<float> values) {
    for (std::size_t i = 0; i < points.size(); ++i) values[i] = distance(points[i]);
  };
}

float sphere(const Vector3f& p, const Vector3f& center, float radius) {
  return (p - center).norm() - radius;
}
float torus(const Vector3f& p) { return std::hypot(std::hypot(p.x(), p.y()) - 0.6f, p.z()) - 0.2f; }
/// A seat on four legs that pass between the points of the grid of 32.
float stool(const Vector3f& p) {
  const Vector3f beyond = (p - Vector3f(0, 0, 0.5f)).cwiseAbs() - Vector3f(0.6f, 0.6f, 0.08f);
  float value = beyond.cwiseMax(0).norm() + std::min(beyond.maxCoeff(), 0.0f);
  const float across =
      std::hypot(std::abs(p.x()) - 0.515f, std::abs(p.y()) - 0.515f);  // from a leg's axis
  const float along = std::max(p.z() - 0.5f, -0.9f - p.z());
  const float leg = std::hypot(across, std::max(along, 0.0f)) - 0.04f;
  return std::min(value, leg);
}

SdfMesherConfig dense() {
  SdfMesherConfig config;
  config.coarse_resolution = config.resolution;
  return config;
}

bool same(const Mesh& a, const Mesh& b) { return a.vertices == b.vertices && a.faces == b.faces; }

/// Order of vertices and faces aside.
std::multiset<std::array<double, 9>> triangles(const Mesh& mesh) {
  std::multiset<std::array<double, 9>> result;
  for (const Eigen::Vector3i& face : mesh.faces) {
    std::array<std::array<double, 3>, 3> corners;
    for (int k = 0; k < 3; ++k) {
      const Eigen::Vector3d& v = mesh.vertices[static_cast<std::size_t>(face[k])];
      corners[static_cast<std::size_t>(k)] = {v.x(), v.y(), v.z()};
    }
    std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
    std::array<double, 9> flat;
    for (std::size_t k = 0; k < 9; ++k) flat[k] = corners[k / 3][k % 3];
    result.insert(flat);
  }
  return result;
}

long eulerNumber(const Mesh& mesh) {
  // A closed mesh has three edges for two faces.
  return static_cast<long>(mesh.vertices.size()) - static_cast<long>(mesh.faces.size()) / 2;
}

TEST(MeshLevelSet, PutsTheVerticesOfASphereOnItsRadius) {
  const auto mesh = meshLevelSet(
      fieldOf([](const Vector3f& p) { return sphere(p, Vector3f::Zero(), 0.7f); }), {});
  ASSERT_TRUE(mesh);
  for (const Eigen::Vector3d& v : mesh->vertices) EXPECT_NEAR(v.norm(), 0.7, 3e-4);
  EXPECT_TRUE(analyzeTopology(*mesh).watertight());
  EXPECT_EQ(eulerNumber(*mesh), 2);
  const double volume = 4.0 / 3.0 * std::numbers::pi * 0.7 * 0.7 * 0.7;
  EXPECT_NEAR(signedVolume(*mesh), volume, 0.002 * volume);  // positive: oriented outwards
}

TEST(MeshLevelSet, KeepsTheHoleOfATorus) {
  const auto mesh = meshLevelSet(fieldOf(torus), {});
  ASSERT_TRUE(mesh);
  EXPECT_TRUE(analyzeTopology(*mesh).watertight());
  EXPECT_EQ(eulerNumber(*mesh), 0);
}

TEST(MeshLevelSet, KeepsTheLargerOfTwoSpheres) {
  const auto mesh = meshLevelSet(fieldOf([](const Vector3f& p) {
                                   return std::min(sphere(p, Vector3f(-0.6f, 0, 0), 0.3f),
                                                   sphere(p, Vector3f(0.5f, 0, 0), 0.4f));
                                 }),
                                 {});
  ASSERT_TRUE(mesh);
  EXPECT_EQ(analyzeTopology(*mesh).components, 1u);
  for (const Eigen::Vector3d& v : mesh->vertices) EXPECT_GT(v.x(), 0);
}

TEST(MeshLevelSet, KeepsPiecesAsLargeAsAskedFor) {
  // Areas as 16, 9 and 1.
  const auto spheres = fieldOf([](const Vector3f& p) {
    return std::min({sphere(p, Vector3f(-0.6f, 0, 0), 0.3f), sphere(p, Vector3f(0.5f, 0, 0), 0.4f),
                     sphere(p, Vector3f(0, 0.8f, 0), 0.1f)});
  });
  SdfMesherConfig config;
  const auto pieces = [&](double min_share) {
    config.min_piece_share = min_share;
    const auto mesh = meshLevelSet(spheres, config);
    return mesh ? analyzeTopology(*mesh).components : 0;
  };
  EXPECT_EQ(pieces(1), 1u);
  EXPECT_EQ(pieces(0.5), 2u);
  EXPECT_EQ(pieces(0.1), 2u);
  EXPECT_EQ(pieces(0), 3u);
}

TEST(MeshLevelSet, LiesWhereTheFieldHasTheLevel) {
  SdfMesherConfig config;
  config.level = 0.05;
  const auto mesh = meshLevelSet(
      fieldOf([](const Vector3f& p) { return sphere(p, Vector3f::Zero(), 0.7f); }), config);
  ASSERT_TRUE(mesh);
  for (const Eigen::Vector3d& v : mesh->vertices) EXPECT_NEAR(v.norm(), 0.75, 3e-4);
}

TEST(MeshLevelSet, IsUndefinedWhereNothingCrossesZero) {
  EXPECT_FALSE(meshLevelSet(fieldOf([](const Vector3f&) { return 0.3f; }), {}));
  EXPECT_FALSE(meshLevelSet(fieldOf([](const Vector3f&) { return -0.3f; }), {}));
  EXPECT_FALSE(meshLevelSet(fieldOf([](const Vector3f&) { return 0.0f; }), {}));
}

TEST(MeshLevelSet, IsUndefinedWhereAValueIsNotFinite) {
  constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
  EXPECT_FALSE(meshLevelSet(fieldOf([](const Vector3f&) { return kNan; }), {}));
  const auto sphereBut = [](float wrong, float from_x) {
    return fieldOf([=](const Vector3f& p) {
      return p.x() > from_x ? wrong : sphere(p, Vector3f::Zero(), 0.7f);
    });
  };
  EXPECT_FALSE(meshLevelSet(sphereBut(kNan, 0.69f), {}));
  EXPECT_FALSE(meshLevelSet(sphereBut(std::numeric_limits<float>::infinity(), 0.69f), {}));
  EXPECT_FALSE(meshLevelSet(sphereBut(-std::numeric_limits<float>::infinity(), 0.69f), {}));
}

TEST(MeshLevelSet, IsOpenOnlyWhereTheSurfaceLeavesTheCube) {
  const auto mesh = meshLevelSet(fieldOf([](const Vector3f& p) { return p.z() - 0.21f; }), {});
  ASSERT_TRUE(mesh);
  const MeshTopology topology = analyzeTopology(*mesh);
  EXPECT_NEAR(topology.boundary_length, 4 * 2.2, 1e-6);
  EXPECT_EQ(topology.nonmanifold_edges + topology.misoriented_edges, 0u);
  EXPECT_NEAR(surfaceArea(*mesh), 2.2 * 2.2, 1e-6);
}

TEST(MeshLevelSet, IsClosedWhereTheSurfaceMeetsGridPoints) {
  // Pitch 2.2 / 64: the faces of the cube lie on grid planes.
  constexpr float kHalf = 16 * 2.2f / 64;
  const auto mesh =
      meshLevelSet(fieldOf([](const Vector3f& p) { return p.cwiseAbs().maxCoeff() - kHalf; }), {});
  ASSERT_TRUE(mesh);
  EXPECT_TRUE(analyzeTopology(*mesh).watertight());
}

class MeshLevelSetCases : public ::testing::TestWithParam<float (*)(const Vector3f&)> {};
INSTANTIATE_TEST_SUITE_P(Shapes, MeshLevelSetCases, ::testing::Values(&torus, &stool));

TEST_P(MeshLevelSetCases, EqualsTheDenseGrid) {
  const auto sparse = meshLevelSet(fieldOf(GetParam()), {});
  const auto all = meshLevelSet(fieldOf(GetParam()), dense());
  ASSERT_TRUE(sparse && all);
  EXPECT_EQ(triangles(*sparse), triangles(*all));
}

TEST_P(MeshLevelSetCases, AsksForFewPointsAndForNoneTwice) {
  std::vector<std::array<float, 3>> asked;
  setNumThreads(1);
  const auto mesh = meshLevelSet(
      [&](std::span<const Vector3f> points, std::span<float> values) {
        for (std::size_t i = 0; i < points.size(); ++i) {
          asked.push_back({points[i].x(), points[i].y(), points[i].z()});
          values[i] = GetParam()(points[i]);
        }
      },
      {});
  setNumThreads(0);
  ASSERT_TRUE(mesh);
  EXPECT_LT(asked.size(), 65u * 65u * 65u / 4);
  RecordProperty("evaluations", static_cast<int>(asked.size()));
  std::sort(asked.begin(), asked.end());
  EXPECT_EQ(std::adjacent_find(asked.begin(), asked.end()), asked.end());
}

TEST_P(MeshLevelSetCases, IsTheSameForAnyNumberOfThreads) {
  setNumThreads(1);
  const auto alone = meshLevelSet(fieldOf(GetParam()), {});
  setNumThreads(5);
  const auto together = meshLevelSet(fieldOf(GetParam()), {});
  setNumThreads(0);
  ASSERT_TRUE(alone && together);
  EXPECT_TRUE(same(*alone, *together));
}

TEST(MeshLevelSet, FollowsThinPartsThatTheCoarseGridMisses) {
  SdfMesherConfig config;
  config.refine_margin = 0;  // refines only where the coarse corners differ in sign: the seat
  const auto mesh = meshLevelSet(fieldOf(stool), config);
  ASSERT_TRUE(mesh);
  EXPECT_NEAR(bounds(*mesh).min().z(), -0.94, 0.01);
  EXPECT_TRUE(analyzeTopology(*mesh).watertight());
}

/// Half way between planes of the grid of 32: no corner of a cell of that grid is inside.
float sheet(const Vector3f& p) { return std::abs(p.z() - 2.2f / 64) - 0.02f; }

TEST(MeshLevelSet, SeesASheetThinnerThanACoarseCell) {
  const auto mesh = meshLevelSet(fieldOf(sheet), {});
  ASSERT_TRUE(mesh);
  EXPECT_NEAR(surfaceArea(*mesh), 2.2 * 2.2, 1e-6);  // one of the two sides
}

TEST(MeshLevelSet, WorksOnAClampedDistance) {
  const auto exact = meshLevelSet(fieldOf(stool), {});
  const auto clamped = meshLevelSet(
      fieldOf([](const Vector3f& p) { return std::clamp(stool(p), -0.1f, 0.1f); }), {});
  ASSERT_TRUE(exact && clamped);
  EXPECT_EQ(triangles(*exact), triangles(*clamped));
}

}  // namespace
}  // namespace hydrabench

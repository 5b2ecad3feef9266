// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "metrics/surface_distance.h"

#include <gtest/gtest.h>

#include "core/geometry/surface_sampling.h"
#include "tests/metrics/shapes.h"

namespace hydrabench {
namespace {

using Role = ObjectModel::Role;

ObjectModel model(const Mesh& mesh, Role role, std::size_t samples = 10000) {
  ObjectModel::Config config;
  config.samples = samples;
  config.jittered_origins = 0;
  return ObjectModel(mesh, role, config);
}

/// A sheet in the plane z = height, over [0, size] x [0, 1].
Mesh sheet(double height, double size = 1) {
  Mesh mesh;
  mesh.vertices = {{0, 0, height}, {size, 0, height}, {size, 1, height}, {0, 1, height}};
  mesh.faces = {{0, 1, 2}, {0, 2, 3}};
  return mesh;
}

TEST(SurfaceDistance, OfParallelSheetsIsTheirGap) {
  const SurfaceDistances d =
      surfaceDistances(model(sheet(0.25), Role::kEstimate), model(sheet(0), Role::kTruth));
  EXPECT_NEAR(*accuracy(d), 0.25, 1e-12);
  EXPECT_NEAR(*completeness(d), 0.25, 1e-12);
  EXPECT_NEAR(*chamferL1(d), 0.25, 1e-12);
}

TEST(SurfaceDistance, APartialScanIsAccurateButIncomplete) {
  // The right half of the unit sheet is missing: its points are x - 1/2 away, on average 1/4; half
  // of all points, so 1/8.
  const SurfaceDistances d =
      surfaceDistances(model(sheet(0, 0.5), Role::kEstimate), model(sheet(0, 1), Role::kTruth));
  EXPECT_EQ(accuracy(d), 0.0);
  EXPECT_NEAR(*completeness(d), 1.0 / 8, 2e-3);
  EXPECT_NEAR(*chamferL1(d), 1.0 / 16, 1e-3);
}

TEST(ChamferSq, OfParallelSheetsIsTwiceTheSquaredGap) {
  const double value =
      *chamferSq(model(sheet(0.25), Role::kEstimate), model(sheet(0), Role::kTruth));
  EXPECT_NEAR(value, 2 * 0.0625,
              2e-4);  // plus the squared spacing of samples, about 1 / (pi N) per side
  EXPECT_GT(value, 2 * 0.0625);
}

TEST(ChamferSq, OfASurfaceWithItselfIsItsSamplingFloor) {
  const ObjectModel estimate = model(sheet(0), Role::kEstimate);
  const ObjectModel truth = model(sheet(0), Role::kTruth);
  // Nearest neighbour in a Poisson field of density N: mean squared distance 1 / (pi N), both ways.
  const double expected = 2 / (3.14159265 * 10000);
  EXPECT_NEAR(*truth.samplingFloor(), expected, 0.05 * expected);
  EXPECT_NEAR(*chamferSq(estimate, truth), expected, 0.05 * expected);
}

TEST(ChamferSq, SumsBothDirections) {
  const ObjectModel half = model(sheet(0, 0.5), Role::kEstimate);
  const ObjectModel whole = model(sheet(0, 1), Role::kTruth);
  // Missing points: x - 1/2 uniform in [0, 1/2], mean square 1/12, half of all: 1/24. The other way
  // only the floor.
  EXPECT_NEAR(*chamferSq(half, whole), 1.0 / 24, 1e-3);
}

TEST(SurfaceDistance, AgainstItselfIsExactlyZeroForClosedAndOpenMeshes) {
  const Eigen::Vector3d far(31.7, -12.3, 4.9);
  for (const Mesh& mesh :
       {potato(far, 0.4, 3), openTopCube(), sheet(0.3),
        without(potato(far, 0.4, 3), [&](const auto& c) { return c.x() > far.x(); })}) {
    const SurfaceDistances d =
        surfaceDistances(model(mesh, Role::kEstimate), model(mesh, Role::kTruth));
    EXPECT_EQ(accuracy(d), 0.0);
    EXPECT_EQ(completeness(d), 0.0);
    EXPECT_EQ(chamferL1(d), 0.0);
    EXPECT_EQ(fScore(countWithin(d, 1e-12)), 1.0);
  }
}

TEST(SurfaceDistance, IsUndefinedWithoutASurface) {
  const ObjectModel empty = model(Mesh(), Role::kEstimate);
  const ObjectModel cube = model(unitCube(), Role::kTruth);
  EXPECT_FALSE(empty.hasSurface());
  EXPECT_EQ(chamferSq(empty, cube), std::nullopt);
  EXPECT_EQ(empty.samplingFloor(), std::nullopt);
  const SurfaceDistances d = surfaceDistances(empty, cube);
  EXPECT_EQ(accuracy(d), std::nullopt);
  EXPECT_EQ(completeness(d), std::nullopt);
  EXPECT_EQ(chamferL1(d), std::nullopt);
}

TEST(SurfaceDistance, IsUnchangedByRigidMotionOfBoth) {
  const Mesh estimate = potato({0, 0, 0}, 0.4, 3, 0.5);
  const Mesh truth = potato({0.02, 0, 0}, 0.4, 3);
  const Transform motion = Eigen::Translation3d(3, -2, 1) *
                           Eigen::AngleAxisd(1.1, Eigen::Vector3d(1, 2, 3).normalized());
  const ObjectModel e = model(estimate, Role::kEstimate), g = model(truth, Role::kTruth);
  const ObjectModel e_moved = model(transformed(motion, estimate), Role::kEstimate);
  const ObjectModel g_moved = model(transformed(motion, truth), Role::kTruth);
  EXPECT_NEAR(*chamferSq(e, g), *chamferSq(e_moved, g_moved), 1e-9);
  const SurfaceDistances before = surfaceDistances(e, g),
                         after = surfaceDistances(e_moved, g_moved);
  EXPECT_NEAR(*chamferL1(before), *chamferL1(after), 1e-9);
  EXPECT_NEAR(*fScore(countWithin(before, 0.02)), *fScore(countWithin(after, 0.02)), 1e-3);
}

TEST(SurfaceDistance, DoesNotDependOnHowTheSurfaceIsCutIntoFaces) {
  Mesh dense = sheet(
      0.1);  // the right triangle fan is very fine: a mean over vertices would see nothing else
  for (int i = 1; i < 200; ++i) {
    dense.vertices.emplace_back(1, i / 200.0, 0.1);
  }
  dense.faces = {{0, 2, 3}};
  int last = 1;
  for (int i = 4; i < 203; ++i) dense.faces.emplace_back(0, std::exchange(last, i), i);
  dense.faces.emplace_back(0, last, 2);
  const Mesh tilted = [] {
    Mesh mesh = sheet(0);
    mesh.vertices[1].z() = mesh.vertices[2].z() = 0.1;
    return mesh;
  }();
  const ObjectModel truth = model(tilted, Role::kTruth);
  const double coarse_accuracy =
      *accuracy(surfaceDistances(model(sheet(0.1), Role::kEstimate), truth));
  const double dense_accuracy = *accuracy(surfaceDistances(model(dense, Role::kEstimate), truth));
  EXPECT_NEAR(coarse_accuracy, dense_accuracy, 1e-3);
}

TEST(FScore, IsTheHandWorkedFraction) {
  EXPECT_DOUBLE_EQ(*fScore({4, 3, 10, 5}), 2 * 0.75 * 0.5 / 1.25);
  EXPECT_EQ(fScore({4, 4, 10, 10}), 1.0);
}

TEST(FScore, EmptyEstimateScoresZero) { EXPECT_EQ(fScore({0, 0, 10, 0}), 0.0); }
TEST(FScore, NothingWithinScoresZero) { EXPECT_EQ(fScore({4, 0, 10, 0}), 0.0); }
TEST(FScore, BothEmptyIsUndefined) { EXPECT_EQ(fScore({}), std::nullopt); }

TEST(FScore, CountsAddUpBeforeTheyAreDivided) {
  SurfaceCounts pooled{4, 4, 4, 4};
  pooled += {4, 0, 12, 0};
  EXPECT_DOUBLE_EQ(*fScore(pooled), 2 * 0.5 * 0.25 / 0.75);
}

TEST(FScore, TheThresholdIsStrict) {
  const SurfaceDistances d{{0.5, 0.25}, {0.5, 0.125}};
  EXPECT_EQ(countWithin(d, 0.5).estimate_within, 1u);
  EXPECT_EQ(countWithin(d, 0.125).truth_within, 0u);
}

TEST(FScore, OfAPartialScanIsBoundedByTheMissingPart) {
  const SurfaceDistances d =
      surfaceDistances(model(sheet(0, 0.5), Role::kEstimate), model(sheet(0, 1), Role::kTruth));
  // P = 1; R = 1/2 plus the strip of 5 cm beside the cut.
  EXPECT_NEAR(*fScore(countWithin(d, 0.05)), 2 * 0.55 / 1.55, 5e-3);
}

}  // namespace
}  // namespace hydrabench

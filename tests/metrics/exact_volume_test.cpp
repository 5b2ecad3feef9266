// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "core/geometry/mesh_repair.h"
#include "metrics/voxelize.h"
#include "tests/metrics/shapes.h"

// v_iou at a fine pitch against CGAL's exact boolean volume: an independent way to the same number.
namespace hydrabench {
namespace {

double exactIou(const Mesh& a, const Mesh& b) {
  const double shared = intersectionVolume(a, b);
  return shared / (signedVolume(a) + signedVolume(b) - shared);
}

double fineVoxelIou(const Mesh& a, const Mesh& b) {
  const VoxelLattice grid{0.004, {0.0011, 0.0023, 0.0007}};
  return *voxelIou(*SolidVoxelizer(a).voxelize(grid), *SolidVoxelizer(b).voxelize(grid));
}

TEST(ExactVolume, OfOverlappingSpheres) {
  const Mesh a = sphereMesh({0, 0, 0}, 0.5, 3);
  const Mesh b = sphereMesh({0.31, 0.12, 0.05}, 0.4, 3);
  EXPECT_NEAR(fineVoxelIou(a, b), exactIou(a, b), 1e-3);
}

TEST(ExactVolume, OfTurnedBoxes) {
  const Mesh a = cuboid({0, 0, 0}, {0.9, 0.5, 0.6});
  const Transform turn = Eigen::Translation3d(0.2, -0.1, 0.05) *
                         Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, 3).normalized());
  const Mesh b = transformed(turn, a);
  EXPECT_NEAR(fineVoxelIou(a, b), exactIou(a, b), 1e-3);
}

TEST(ExactVolume, OfShapesThatAreNotConvex) {
  const Mesh a = potato({0, 0, 0}, 0.5, 3);
  const Mesh b = potato({0.07, 0.05, -0.04}, 0.5, 3, 1.3);
  EXPECT_NEAR(fineVoxelIou(a, b), exactIou(a, b), 1e-3);
}

}  // namespace
}  // namespace hydrabench

// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "metrics/voxelize.h"

#include <gtest/gtest.h>

#include "core/types/random.h"
#include "tests/metrics/shapes.h"

namespace hydrabench {
namespace {

VoxelSet solid(const Mesh& mesh, const VoxelLattice& grid) {
  return *SolidVoxelizer(mesh).voxelize(grid);
}

TEST(SolidVoxels, OfAUnitCubeAreItsCells) {
  for (const double pitch : {0.5, 0.1, 0.05, 0.04, 0.025}) {
    const double cells_per_edge = std::round(1 / pitch);
    EXPECT_EQ(static_cast<double>(solid(unitCube(), {pitch}).count()), std::pow(cells_per_edge, 3));
  }
}

TEST(SolidVoxels, AShiftOfAMultipleOfThePitchGivesTheExactFraction) {
  for (const double pitch : {0.05, 0.1}) {
    for (int steps = 0; steps * pitch < 1; ++steps) {
      const double d = steps * pitch;
      const double n = std::round(1 / pitch);
      // In cells, so that the expected value is one rounded division as well: (n - steps) / (n +
      // steps) = (1 - d) / (1 + d).
      const double expected = (n - steps) / (n + steps);
      const VoxelLattice grid{pitch};
      EXPECT_EQ(voxelIou(solid(unitCube(), grid), solid(unitCube(d), grid)), expected) << d;
      EXPECT_NEAR(expected, (1 - d) / (1 + d), 1e-12);
    }
  }
}

TEST(SolidVoxels, TheExactFractionHoldsForEveryOrigin) {
  for (const VoxelLattice& grid : jitteredGrids({0.05}, 50, 1)) {
    EXPECT_EQ(voxelIou(solid(unitCube(), grid), solid(unitCube(0.3), grid)), 14.0 / 26);
  }
  // Faces through the centres of cells: half-open, each layer belongs to one cube only.
  const VoxelLattice through_centers{0.05, {0.025, 0.025, 0.025}};
  EXPECT_EQ(solid(unitCube(), through_centers).count(), 8000u);
  EXPECT_EQ(
      intersectionCount(solid(unitCube(), through_centers), solid(unitCube(1), through_centers)),
      0u);
}

TEST(SolidVoxels, FarFromTheOriginTheFractionStaysExact) {
  const VoxelLattice grid{0.05};
  const Eigen::Vector3d far(123.45, -67.85, 12.35);
  EXPECT_EQ(voxelIou(solid(moved(unitCube(), far), grid), solid(moved(unitCube(0.3), far), grid)),
            14.0 / 26);
}

TEST(SolidVoxels, CountedCrossingsAgreeWithTheWindingNumberOfClosedMeshes) {
  Random random(4);
  for (int i = 0; i < 6; ++i) {
    const Eigen::Vector3d center(random.uniform(), random.uniform(), random.uniform());
    const Mesh mesh = potato(center, 0.4, 2, i);
    for (const VoxelLattice& grid : jitteredGrids({0.06}, 2, 3)) {
      EXPECT_EQ(solid(mesh, grid), solidVoxelsReference(mesh, grid));
    }
  }
}

TEST(SolidVoxels, ColumnsThroughVerticesAndEdgesDoNotLeak) {
  // An octahedron with its corners and edges exactly above the centres of cells.
  Mesh octahedron;
  octahedron.vertices = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  octahedron.faces = {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4},
                      {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
  const VoxelLattice grid{0.1, {0.05, 0.05, 0.05}};
  const VoxelSet cells = solid(octahedron, grid);
  EXPECT_TRUE(cells.contains(-1, -1, -1));  // its centre is the origin
  for (const VoxelSet::Run& run : cells.runs()) {
    for (int z = run.z_begin; z < run.z_end; ++z) {
      const Eigen::Vector3d center =
          grid.origin + 0.1 * Eigen::Vector3d(run.x + .5, run.y + .5, z + .5);
      EXPECT_LE(center.lpNorm<1>(), 1 + 1e-9);
    }
  }
  EXPECT_NEAR(static_cast<double>(cells.count()) * 1e-3, 4.0 / 3, 0.05);
}

TEST(SolidVoxels, OverlappingClosedPartsAreOneSolid) {
  Mesh both = unitCube();
  append(unitCube(0.5), both);
  EXPECT_TRUE(SolidVoxelizer(both).countsCrossings());
  EXPECT_EQ(solid(both, {0.1}), solid(cuboid({0, 0, 0}, {1.5, 1, 1}), {0.1}));
}

TEST(SolidVoxels, PartsThatShareAnEdgeStillCountCrossings) {
  Mesh both = unitCube();
  append(cuboid({1, 1, 0}, {2, 2, 1}), both);
  EXPECT_TRUE(SolidVoxelizer(both).countsCrossings());
  EXPECT_EQ(solid(both, {0.1}).count(), 2000u);
}

TEST(SolidVoxels, AMeshTurnedInsideOutIsTurnedBack) {
  Mesh inverted = unitCube();
  for (Eigen::Vector3i& face : inverted.faces) std::swap(face[0], face[1]);
  EXPECT_EQ(solid(inverted, {0.1}), solid(unitCube(), {0.1}));
}

TEST(SolidVoxels, OfAnOpenMeshAreWhereTheWindingNumberExceedsOneHalf) {
  const Mesh open = openTopCube();
  EXPECT_FALSE(SolidVoxelizer(open).countsCrossings());
  const VoxelLattice grid{0.1, {0.03, 0.03, 0.03}};
  const VoxelSet cells = solid(open, grid);
  EXPECT_EQ(cells, solidVoxelsReference(open, grid));
  // From anywhere inside, the missing lid hides less than half of all directions: it is closed by a
  // plane.
  EXPECT_EQ(cells, solid(unitCube(), grid));
  // Without lid and bottom, the tube is open where more than half is missing: near both ends.
  const Mesh tube = without(open, [](const Eigen::Vector3d& center) { return center.z() < 0.001; });
  const VoxelSet tube_cells = solid(tube, grid);
  EXPECT_EQ(tube_cells, solidVoxelsReference(tube, grid));
  EXPECT_TRUE(tube_cells.contains(5, 5, 5));
  EXPECT_FALSE(tube_cells.contains(5, 5, 9));
}

TEST(SolidVoxels, OfAPartialScanAgreeWithTheReference) {
  const Mesh scan = without(potato({0, 0, 0}, 0.5, 3),
                            [](const Eigen::Vector3d& center) { return center.x() > 0.1; });
  const VoxelSet fast = solid(scan, {0.05}), reference = solidVoxelsReference(scan, {0.05});
  // Only centres whose winding number is 1/2 up to the error of the far field may differ.
  const std::size_t shared = intersectionCount(fast, reference);
  EXPECT_LE(fast.count() + reference.count() - 2 * shared, reference.count() / 100);
  EXPECT_GT(reference.count(), 300u);
}

TEST(SolidVoxels, AFlatSheetHasNone) {
  Mesh sheet;
  sheet.vertices = {{0, 0, 0}, {1, 0, 0.1}, {1, 1, 0}, {0, 1, 0.1}};
  sheet.faces = {{0, 1, 2}, {0, 2, 3}};
  EXPECT_EQ(solid(sheet, {0.1}).count(), 0u);
  EXPECT_EQ(solid(Mesh(), {0.1}).count(), 0u);
}

TEST(SurfaceVoxels, AFaceOnABorderBelongsToOneLayerOnly) {
  Mesh sheet;  // z = 1 exactly, x and y inside (0.1, 0.9)
  sheet.vertices = {{0.1, 0.1, 1}, {0.9, 0.1, 1}, {0.9, 0.9, 1}, {0.1, 0.9, 1}};
  sheet.faces = {{0, 1, 2}, {0, 2, 3}};
  const VoxelSet cells = *surfaceVoxels(sheet, {0.5});
  EXPECT_EQ(cells.count(), 4u);
  EXPECT_TRUE(cells.contains(0, 0, 2));
  EXPECT_FALSE(cells.contains(0, 0, 1));
}

TEST(SurfaceVoxels, OfAUnitCubeAreTheHandCountedShell) {
  // Faces at 0 lie in the first layer of 10, faces at 1 in the layer behind the last: a hollow
  // block of 11^3 cells.
  EXPECT_EQ(surfaceVoxels(unitCube(), {0.1})->count(), 11u * 11 * 11 - 9 * 9 * 9);
  // With the origin moved by half a pitch the faces run through layers -1 and 9: the same number of
  // cells.
  EXPECT_EQ(surfaceVoxels(unitCube(), {0.1, {0.05, 0.05, 0.05}})->count(), 1331u - 729);
}

TEST(SurfaceVoxels, AnObliqueTriangleTouchesOnlyWhatItCrosses) {
  Mesh triangle;  // the plane x + y + z = 1.5 in a block of 2^3 cells of edge 1; misses the
                  // corners' cells
  triangle.vertices = {{1.5, 0, 0}, {0, 1.5, 0}, {0, 0, 1.5}};
  triangle.faces = {{0, 1, 2}};
  const VoxelSet cells = *surfaceVoxels(triangle, {1.0});
  EXPECT_EQ(cells.count(), 4u);
  EXPECT_TRUE(cells.contains(0, 0, 0));
  EXPECT_TRUE(cells.contains(1, 0, 0));
  EXPECT_FALSE(cells.contains(1, 1, 0));
}

TEST(SurfaceVoxels, HoldEverySampleAndNoCellFarFromOne) {
  const Mesh mesh = potato({0.3, 0.2, 0.1}, 0.5, 2);
  const VoxelLattice grid{0.07, {0.01, 0.02, 0.03}};
  const VoxelSet cells = *surfaceVoxels(mesh, grid);
  Random random(8);
  std::vector<Eigen::Vector3i> reached;
  for (const Eigen::Vector3i& face : mesh.faces) {
    for (int i = 0; i < 1500; ++i) {
      const double root = std::sqrt(random.uniform()), along = random.uniform();
      const auto& a = mesh.vertices[static_cast<std::size_t>(face[0])];
      const auto& b = mesh.vertices[static_cast<std::size_t>(face[1])];
      const auto& c = mesh.vertices[static_cast<std::size_t>(face[2])];
      const Eigen::Vector3d point = a + root * ((b - a) + along * (c - b));
      const Eigen::Vector3i cell =
          ((point - grid.origin) / grid.pitch_m).array().floor().matrix().cast<int>();
      ASSERT_TRUE(cells.contains(cell.x(), cell.y(), cell.z()));
      reached.push_back(cell);
    }
  }
  const auto less = [](const Eigen::Vector3i& a, const Eigen::Vector3i& b) {
    return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end());
  };
  std::sort(reached.begin(), reached.end(), less);
  reached.erase(std::unique(reached.begin(), reached.end()), reached.end());
  // Slivers of a cell may miss all samples; whole wrong cells would show.
  EXPECT_GE(static_cast<double>(reached.size()), 0.98 * static_cast<double>(cells.count()));
}

TEST(Voxels, AMeshTooLargeForTheGridHasNone) {
  const Mesh giant = cuboid({0, 0, 0}, {1000, 1000, 1000});
  EXPECT_FALSE(SolidVoxelizer(giant).voxelize({0.05}));
  EXPECT_FALSE(surfaceVoxels(giant, {0.05}));
  EXPECT_FALSE(surfaceVoxels(moved(unitCube(), {1e12, 0, 0}), {0.05}));
}

}  // namespace
}  // namespace hydrabench

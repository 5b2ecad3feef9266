// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "core/shape/latent_flow/view_grid.h"

#include <cmath>

#include <gtest/gtest.h>

namespace hydrabench {
namespace {

constexpr double kCell = 2 * kGridHalfSide / kCellSide;

/// Features of the cell that a place of the cube lies in.
const float* cellAt(const ViewGrid& grid, const Eigen::Vector3d& p) {
  const Eigen::Vector3i cell = ((p.array() + kGridHalfSide) / kCell).floor().cast<int>();
  const Eigen::Vector3i block = cell / 4;
  const Eigen::Vector3i inner = cell - 4 * block;
  const int index = (16 * block.z() + 4 * block.y() + block.x()) * 64 +
                    (16 * inner.z() + 4 * inner.y() + inner.x());
  return &grid.cells[static_cast<std::size_t>(index * ViewGrid::kCellFeatures)];
}

/// An object frame 4 m before the camera, turned by a quarter, half a metre to the unit.
LocalFrame frame() {
  LocalFrame result;
  result.center = {4, 0, -1};
  result.bearing = std::acos(0.0);
  result.scale = 0.5;
  return result;
}

ViewGrid gridOf(const std::vector<Eigen::Vector3d>& object,
                const std::vector<Eigen::Vector3d>& context) {
  ObjectPoints points;
  for (const auto& p : object) points.object.push_back(frame().toLevel(p).cast<float>());
  for (const auto& p : context) points.context.push_back(frame().toLevel(p).cast<float>());
  return makeViewGrid(points, frame());
}

TEST(ViewGrid, HoldsWhereTheObjectWasMeasured) {
  // Two points of one cell, an eighth and three eighths of it beyond its middle along x.
  const Eigen::Vector3d middle = Eigen::Vector3d::Constant(0.5 * kCell);
  const ViewGrid grid = gridOf(
      {middle + Eigen::Vector3d(kCell / 8, 0, 0), middle + Eigen::Vector3d(3 * kCell / 8, 0, 0)},
      {});
  const float* cell = cellAt(grid, middle);
  EXPECT_NEAR(cell[0], 0.5 * std::log(3), 1e-6);
  EXPECT_NEAR(cell[1], 2 * 0.25, 1e-4);
  EXPECT_NEAR(cell[2], 0, 1e-4);
  EXPECT_NEAR(cell[3], 0, 1e-4);
  EXPECT_EQ(cell[5], 0);
}

TEST(ViewGrid, IsFreeBeforeWhatWasMeasuredAndUnknownBehindIt) {
  // The camera stands 8 units away where y is positive.
  const Eigen::Vector3d camera = frame().toLocal(Eigen::Vector3d::Zero());
  EXPECT_NEAR(camera.y(), 8, 1e-9);
  const Eigen::Vector3d wall(0.05, -0.2, 0.35);
  const Eigen::Vector3d towards = (camera - wall).normalized();
  for (const bool on_object : {true, false}) {
    const ViewGrid grid = on_object ? gridOf({wall}, {}) : gridOf({}, {wall});
    EXPECT_EQ(cellAt(grid, wall + 0.5 * towards)[4], 1);
    EXPECT_EQ(cellAt(grid, wall)[4], 0);
    EXPECT_EQ(cellAt(grid, wall - 0.5 * towards)[4], 0);
    EXPECT_EQ(cellAt(grid, wall)[5], on_object ? 0 : 1);
  }
}

TEST(ViewGrid, SeesThroughTheCubeToWhatLiesBehind) {
  const Eigen::Vector3d middle(0.04, 0.02, 0.05);
  const Eigen::Vector3d towards = (frame().toLocal(Eigen::Vector3d::Zero()) - middle).normalized();
  const ViewGrid grid = gridOf({}, {middle - 2 * towards});
  int free = 0;
  for (double at = -1; at < 1; at += 0.05) free += cellAt(grid, middle + at * towards)[4] == 1;
  EXPECT_GE(free, 36);  // of 40: a cell that the ray only grazes may be missed
}

TEST(ViewGrid, TellsSizeCameraAndFloor) {
  ObjectPoints points;
  points.object = {frame().toLevel({0, 0, 0.4}).cast<float>()};
  points.context = {frame().toLevel({1, 0, -1}).cast<float>()};
  points.cut = {0, 1, 0, 1};
  const ViewGrid grid = makeViewGrid(points, frame());
  const Eigen::Vector3d camera(0, 8, 2);
  EXPECT_NEAR(grid.globals[0], std::log(0.5), 1e-6);
  for (int axis = 0; axis < 3; ++axis) {
    EXPECT_NEAR(grid.globals[1 + axis], camera[axis] / camera.norm(), 1e-6);
  }
  EXPECT_NEAR(grid.globals[4], std::log(camera.norm()), 1e-6);
  EXPECT_NEAR(grid.globals[5], 2, 1e-6);
  EXPECT_NEAR(grid.globals[6], -1, 1e-5);
  EXPECT_NEAR(grid.globals[7], 0.4, 1e-5);
  EXPECT_EQ(grid.globals[9], 1);
  EXPECT_EQ(grid.globals[10], 0);
}

}  // namespace
}  // namespace hydrabench

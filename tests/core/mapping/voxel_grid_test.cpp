// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "core/mapping/voxel_grid.h"

#include <gtest/gtest.h>

namespace hydrabench {
namespace {

TEST(VoxelGrid, PutsNegativeCoordinatesIntoTheCellBelow) {
  const VoxelGrid grid{0.1, 16};
  EXPECT_EQ(grid.voxelAt({-0.01, 0.01, -1.61}), GlobalVoxel(-1, 0, -17));
  EXPECT_EQ(grid.blockAt({-0.01, 0.01, -1.61}), BlockIndex(-1, 0, -2));
  EXPECT_EQ(grid.blockOf({-16, -17, 15}), BlockIndex(-1, -2, 0));
  EXPECT_EQ(grid.blockOf({16, -1, -32}), BlockIndex(1, -1, -2));
}

TEST(VoxelGrid, NumbersTheVoxelsOfABlockWithXFastest) {
  const VoxelGrid grid{0.1, 16};
  EXPECT_EQ(grid.localOf({1, 0, 0}), 1u);
  EXPECT_EQ(grid.localOf({0, 1, 0}), 16u);
  EXPECT_EQ(grid.localOf({0, 0, 1}), 256u);
  EXPECT_EQ(grid.localOf({-1, -1, -1}), 4095u);  // the last of block (-1, -1, -1)
  EXPECT_EQ(grid.localOf({-16, -15, -14}), 0u + 16 * 1 + 256 * 2);
}

TEST(VoxelGrid, FindsAVoxelBackFromBlockAndNumber) {
  const VoxelGrid grid{0.05, 8};
  for (int x = -17; x <= 17; x += 3) {
    for (int y = -9; y <= 9; y += 2) {
      const GlobalVoxel voxel(x, y, x - y);
      EXPECT_EQ(grid.globalOf(grid.blockOf(voxel), grid.localOf(voxel)), voxel);
      EXPECT_EQ(grid.voxelAt(grid.centerOf(voxel)), voxel);
    }
  }
}

TEST(VoxelGrid, CentresLieHalfASizeIn) {
  const VoxelGrid grid{0.1, 16};
  EXPECT_TRUE(grid.centerOf({0, -1, 9}).isApprox(Eigen::Vector3d(0.05, -0.05, 0.95)));
  EXPECT_TRUE(grid.centerOfBlock({0, -1, 1}).isApprox(Eigen::Vector3d(0.8, -0.8, 2.4)));
}

}  // namespace
}  // namespace hydrabench

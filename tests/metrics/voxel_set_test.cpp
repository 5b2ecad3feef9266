// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "metrics/voxel_set.h"

#include <gtest/gtest.h>

namespace hydrabench {
namespace {

const VoxelSet kA({{0, 0, 0, 4}, {0, 1, 2, 3}, {2, 0, 0, 1}});
const VoxelSet kB({{0, 0, 2, 6}, {0, 1, 0, 1}, {0, 1, 2, 4}});

TEST(VoxelSet, CountsItsCells) {
  EXPECT_EQ(kA.count(), 6u);
  EXPECT_EQ(kB.count(), 7u);
  EXPECT_EQ(VoxelSet().count(), 0u);
}

TEST(VoxelSet, KnowsItsCells) {
  EXPECT_TRUE(kA.contains(0, 0, 0));
  EXPECT_TRUE(kA.contains(0, 0, 3));
  EXPECT_FALSE(kA.contains(0, 0, 4));
  EXPECT_FALSE(kA.contains(0, 1, 1));
  EXPECT_FALSE(kA.contains(-1, 0, 0));
  EXPECT_FALSE(kA.contains(1, 0, 0));
}

TEST(VoxelIou, IsSharedOverEither) {
  EXPECT_EQ(intersectionCount(kA, kB), 3u);
  EXPECT_DOUBLE_EQ(*voxelIou(kA, kB), 3.0 / 10);
  EXPECT_EQ(voxelIou(kA, kB), voxelIou(kB, kA));
  EXPECT_EQ(voxelIou(kA, kA), 1.0);
}

TEST(VoxelIou, OneEmptyScoresZeroAndBothEmptyIsUndefined) {
  EXPECT_EQ(voxelIou(VoxelSet(), kA), 0.0);
  EXPECT_EQ(voxelIou(kA, VoxelSet()), 0.0);
  EXPECT_EQ(voxelIou(VoxelSet(), VoxelSet()), std::nullopt);
}

TEST(JitteredGrids, BeginWithTheGridItselfAndStayWithinOnePitch) {
  const VoxelLattice grid{0.1, {1, 2, 3}};
  const auto grids = jitteredGrids(grid, 20, 7);
  ASSERT_EQ(grids.size(), 21u);
  EXPECT_EQ(grids[0].origin, grid.origin);
  for (const VoxelLattice& moved : grids) {
    EXPECT_EQ(moved.pitch_m, 0.1);
    EXPECT_TRUE(((moved.origin - grid.origin).array() >= 0).all());
    EXPECT_TRUE(((moved.origin - grid.origin).array() < 0.1).all());
  }
  EXPECT_NE(grids[1].origin, grids[2].origin);
  EXPECT_EQ(grids[1].origin, jitteredGrids(grid, 1, 7)[1].origin);
}

TEST(OriginSpread, IsMeanDeviationAndRange) {
  const std::optional<double> values[] = {0.25, 0.75};
  const OriginSpread spread = *originSpread(values);
  EXPECT_DOUBLE_EQ(spread.mean, 0.5);
  EXPECT_DOUBLE_EQ(spread.deviation, 0.25);
  EXPECT_DOUBLE_EQ(spread.min, 0.25);
  EXPECT_DOUBLE_EQ(spread.max, 0.75);
}

TEST(OriginSpread, IsUndefinedWhereAValueIs) {
  const std::optional<double> values[] = {0.25, std::nullopt};
  EXPECT_FALSE(originSpread(values));
  EXPECT_FALSE(originSpread({}));
}

}  // namespace
}  // namespace hydrabench

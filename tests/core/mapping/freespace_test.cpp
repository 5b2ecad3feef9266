// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "core/mapping/freespace.h"

#include <vector>

#include <gtest/gtest.h>

#include "core/parallel/parallel_for.h"
#include "core/types/random.h"

namespace hydrabench {
namespace {

constexpr std::int64_t kSecond = 1'000'000'000;
constexpr int kSide = 4;

/// 3 x 3 x 3 blocks of 4^3 voxels of 0.1 m around block (0, 0, 0), all measured and empty: a voxel
/// is full below 0.15 m.
class Freespace : public ::testing::Test {
 protected:
  Freespace()
      : volume_(
            {.voxel_size_m = 0.1, .truncation_m = 0.3, .voxels_per_side = kSide, .semantics = {}}) {
    for (int x = -1; x <= 1; ++x) {
      for (int y = -1; y <= 1; ++y) {
        for (int z = -1; z <= 1; ++z) volume_.allocate({x, y, z});
      }
    }
    for (const BlockIndex& index : volume_.blockIndices()) {
      for (TsdfVoxel& voxel : volume_.find(index)->voxels) voxel = {0.3f, 1, {}};
    }
  }

  TsdfVoxel& tsdf(const GlobalVoxel& voxel) {
    const VoxelGrid& grid = volume_.grid();
    return volume_.find(grid.blockOf(voxel))->voxels[grid.localOf(voxel)];
  }
  const FreespaceVoxel& at(const GlobalVoxel& voxel) {
    const VoxelGrid& grid = volume_.grid();
    return volume_.find(grid.blockOf(voxel))->freespace.at(grid.localOf(voxel));
  }
  void updateAll(double time_s) { update(volume_.blockIndices(), time_s); }
  void update(const std::vector<BlockIndex>& blocks, double time_s) {
    FreespaceTracker({}).update(blocks, static_cast<std::int64_t>(time_s * kSecond), volume_);
  }

  TsdfVolume volume_;
};

TEST_F(Freespace, EmptySpaceIsEverFreeExceptWhereItMeetsTheUnknown) {
  updateAll(1);
  for (int x = -kSide; x < 2 * kSide; ++x) {
    for (int y = -kSide; y < 2 * kSide; ++y) {
      for (int z = -kSide; z < 2 * kSide; ++z) {
        const GlobalVoxel voxel(x, y, z);
        const bool inside = voxel.minCoeff() > -kSide && voxel.maxCoeff() < 2 * kSide - 1;
        ASSERT_EQ(at(voxel).ever_free, inside) << voxel.transpose();
        ASSERT_EQ(at(voxel).last_occupied_ns, 0);
      }
    }
  }
}

TEST_F(Freespace, AFullVoxelHoldsBackItsEighteenNeighborsButNotTheCorners) {
  tsdf({0, 0, 0}).distance = 0.149f;
  updateAll(1);
  EXPECT_EQ(at({0, 0, 0}).last_occupied_ns, kSecond);
  int held_back = 0;
  for (int x = -1; x <= 1; ++x) {
    for (int y = -1; y <= 1; ++y) {
      for (int z = -1; z <= 1; ++z) held_back += !at({x, y, z}).ever_free;
    }
  }
  EXPECT_EQ(held_back, 19);
  EXPECT_TRUE(at({1, 1, 1}).ever_free);
  EXPECT_FALSE(at({-1, 1, 0}).ever_free);
  EXPECT_TRUE(at({2, 0, 0}).ever_free);
}

TEST_F(Freespace, FromOneAndAHalfVoxelsOnAVoxelIsEmpty) {
  tsdf({0, 0, 0}).distance = 0.151f;
  updateAll(1);
  EXPECT_TRUE(at({0, 0, 0}).ever_free);
}

TEST_F(Freespace, AnUnmeasuredVoxelIsNotFree) {
  tsdf({0, 0, 0}).weight = 0;
  updateAll(1);
  EXPECT_FALSE(at({0, 0, 0}).ever_free);
  EXPECT_FALSE(at({0, 1, 1}).ever_free);
}

TEST_F(Freespace, WhatWasFullIsFreeMoreThanASecondLater) {
  tsdf({0, 0, 0}).distance = 0;
  updateAll(1);
  tsdf({0, 0, 0}).distance = 0.3f;
  updateAll(2);
  EXPECT_FALSE(at({0, 0, 0}).ever_free);
  updateAll(2.1);
  EXPECT_TRUE(at({0, 0, 0}).ever_free);
}

TEST_F(Freespace, EverFreeIsForGood) {
  updateAll(1);
  tsdf({0, 0, 0}).distance = 0;
  updateAll(2);
  EXPECT_TRUE(at({0, 0, 0}).ever_free);
  EXPECT_EQ(at({0, 0, 0}).last_occupied_ns, 2 * kSecond);
}

TEST_F(Freespace, AWallOutOfViewDoesNotBecomeFreeWithTime) {
  tsdf({4, 1, 1}).distance = 0;  // block (1, 0, 0)
  updateAll(1);
  update({BlockIndex(0, 0, 0)}, 10);
  EXPECT_FALSE(at({3, 1, 1}).ever_free);
}

TEST_F(Freespace, TheFirstInstantOfARunMayBeZero) {
  tsdf({0, 0, 0}).distance = 0;
  updateAll(0);
  tsdf({0, 0, 0}).distance = 0.3f;
  updateAll(0.5);
  EXPECT_FALSE(at({0, 0, 0}).ever_free);
}

TEST_F(Freespace, ThreadsDoNotMatter) {
  const auto run = [&](int threads) {
    setNumThreads(threads);
    std::vector<bool> ever_free;
    Random random(7);
    for (const BlockIndex& index : volume_.blockIndices()) {
      VoxelBlock& block = *volume_.find(index);
      block.freespace.clear();
      for (TsdfVoxel& voxel : block.voxels) voxel.distance = random.chance(0.05) ? 0 : 0.3f;
    }
    updateAll(1);
    setNumThreads(0);
    for (const BlockIndex& index : volume_.blockIndices()) {
      for (const FreespaceVoxel& voxel : volume_.find(index)->freespace) {
        ever_free.push_back(voxel.ever_free);
      }
    }
    return ever_free;
  };
  EXPECT_EQ(run(1), run(4));
}

}  // namespace
}  // namespace hydrabench

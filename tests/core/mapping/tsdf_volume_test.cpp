// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "core/mapping/tsdf_volume.h"

#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/types/error.h"

namespace hydrabench {
namespace {

TEST(TsdfVolume, AllocatesABlockOnce) {
  TsdfVolume volume({});
  VoxelBlock& block = volume.allocate({-1, 2, 0});
  EXPECT_EQ(&volume.allocate({-1, 2, 0}), &block);
  EXPECT_EQ(volume.find({-1, 2, 0}), &block);
  EXPECT_EQ(volume.find({1, 2, 0}), nullptr);
  EXPECT_EQ(volume.numBlocks(), 1u);
  EXPECT_EQ(block.voxels.size(), 4096u);
  EXPECT_EQ(block.voxels[0].weight, 0);
  EXPECT_NE(block.semantics, nullptr);
  EXPECT_TRUE(block.freespace.empty());
}

TEST(TsdfVolume, ListsItsBlocksInOrder) {
  TsdfVolume volume({});
  for (const BlockIndex& index :
       {BlockIndex(1, 0, 0), BlockIndex(-1, 5, 0), BlockIndex(-1, 2, 9), BlockIndex(-1, 2, -9)})
    volume.allocate(index);
  volume.remove({1, 0, 0});
  EXPECT_THAT(
      volume.blockIndices(),
      testing::ElementsAre(BlockIndex(-1, 2, -9), BlockIndex(-1, 2, 9), BlockIndex(-1, 5, 0)));
}

TEST(TsdfVolume, FindsVoxelsByTheirWorldNumber) {
  TsdfVolume volume({});
  VoxelBlock& block = volume.allocate({-1, 0, 0});
  block.voxels[15].distance = 0.25f;  // x = 15 of the block
  ASSERT_NE(volume.voxel({-1, 0, 0}), nullptr);
  EXPECT_EQ(volume.voxel({-1, 0, 0})->distance, 0.25f);
  EXPECT_EQ(volume.voxel({0, 0, 0}), nullptr);
}

TEST(TsdfVolume, AVoxelTakesTwelveBytes) { EXPECT_EQ(sizeof(TsdfVoxel), 12u); }

/// What is wrong with a config; empty: nothing.
std::string faultOf(const std::string& yaml) {
  const ConfigDocument document = ConfigDocument::fromString(yaml);
  ConfigReader reader(document);
  TsdfVolume::Config config;
  read(reader, config);
  try {
    reader.finish();
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(TsdfVolume, RefusesABandNarrowerThanAVoxel) {
  EXPECT_THAT(faultOf("{voxel_size_m: 0.2, truncation_m: 0.1}"),
              testing::HasSubstr("truncation_m"));
}

TEST(TsdfVolume, RefusesBlocksTooLargeForTheMesher) {
  EXPECT_EQ(faultOf("{voxels_per_side: 63}"), "");
  EXPECT_THAT(faultOf("{voxels_per_side: 64}"), testing::HasSubstr("voxels_per_side"));
}

}  // namespace
}  // namespace hydrabench

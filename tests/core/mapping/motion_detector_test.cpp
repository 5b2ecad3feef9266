// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "core/mapping/motion_detector.h"

#include <algorithm>
#include <vector>

#include <gtest/gtest.h>

#include "core/parallel/parallel_for.h"

namespace hydrabench {
namespace {

/// The camera frame is the world. At a depth of 1.05 m pixels are 1 cm apart, so that every tile of
/// 10 x 10 pixels fills one voxel of 0.1 m: tile (i, j) is voxel (i, j, 10).
class Motion : public ::testing::Test {
 protected:
  static constexpr int kTile = 10;
  static constexpr int kColumns = 12;
  static constexpr int kRows = 4;
  static constexpr double kDepth = 1.05;

  Motion()
      : volume_({.voxel_size_m = 0.1, .truncation_m = 0.3, .voxels_per_side = 8, .semantics = {}}) {
    setSize(kColumns, kRows);
  }
  void setSize(int columns, int rows) {
    view_.camera = {kTile * columns, kTile * rows, 105, 105, -0.5, -0.5};
    view_.range = Image<float>(view_.camera.width, view_.camera.height);
  }

  void addPoints(int column, int row) {
    for (int v = row * kTile; v < (row + 1) * kTile; ++v) {
      for (int u = column * kTile; u < (column + 1) * kTile; ++u) {
        view_.range(u, v) = static_cast<float>(view_.camera.backproject(u, v, kDepth).norm());
      }
    }
  }
  void addSeed(int column, int row) {
    const GlobalVoxel voxel(column, row, 10);
    const VoxelGrid& grid = volume_.grid();
    VoxelBlock& block = volume_.allocate(grid.blockOf(voxel));
    block.freespace.resize(grid.voxelsPerBlock());
    block.freespace[grid.localOf(voxel)].ever_free = true;
    addPoints(column, row);
  }
  MotionDetection detect(const MotionDetector::Config& config) const {
    return MotionDetector(config).detect(view_, volume_);
  }
  std::vector<std::size_t> sizes(const MotionDetector::Config& config) const {
    std::vector<std::size_t> sizes;
    for (const auto& cluster : detect(config).clusters) sizes.push_back(cluster.pixels.size());
    return sizes;
  }

  TsdfVolume volume_;
  SensorView view_;
};

using Sizes = std::vector<std::size_t>;

TEST_F(Motion, PointsInEverFreeSpaceAreACluster) {
  addSeed(1, 1);
  addSeed(2, 2);  // touches the first along an edge of the grid
  const MotionDetection found = detect({.min_pixels = 1});
  ASSERT_EQ(found.clusters.size(), 1u);
  const MotionDetection::Cluster& cluster = found.clusters[0];
  EXPECT_EQ(cluster.pixels.size(), 200u);
  EXPECT_TRUE(std::is_sorted(cluster.pixels.begin(), cluster.pixels.end()));
  EXPECT_EQ(std::count(found.ids.begin(), found.ids.end(), 1), 200);
  EXPECT_EQ(found.ids(15, 15), 1);
  EXPECT_EQ(found.ids(15, 25), 0);
}

TEST_F(Motion, WithoutKnownFreeSpaceNothingMoves) {
  for (int column = 0; column < kColumns; ++column) addPoints(column, 0);
  const MotionDetection found = detect({.min_pixels = 1});
  EXPECT_TRUE(found.clusters.empty());
  EXPECT_EQ(found.ids, Image<std::uint8_t>(view_.camera.width, view_.camera.height));
}

TEST_F(Motion, AClusterGrowsByOneVoxelOfPoints) {
  addSeed(1, 1);
  addPoints(2, 2);
  addPoints(3, 2);  // two voxels from the seed
  EXPECT_EQ(sizes({.min_pixels = 1}), (Sizes{200}));
}

TEST_F(Motion, ClustersCloserThanTheSeparationAreOne) {
  addSeed(1, 1);
  addSeed(3, 1);
  EXPECT_EQ(sizes({.min_pixels = 1, .min_separation_voxels = 2}), (Sizes{100, 100}));
  EXPECT_EQ(sizes({.min_pixels = 1, .min_separation_voxels = 2.1}), (Sizes{200}));
}

TEST_F(Motion, PointsThatAClusterGrewByCountForTheSeparation) {
  addSeed(1, 1);
  addPoints(2, 1);
  addSeed(4, 1);
  EXPECT_EQ(sizes({.min_pixels = 1, .min_separation_voxels = 2}), (Sizes{200, 100}));
  EXPECT_EQ(sizes({.min_pixels = 1, .min_separation_voxels = 2.1}), (Sizes{300}));
}

TEST_F(Motion, MergingIsTransitive) {
  addSeed(5, 0);
  addSeed(1, 0);
  addSeed(3, 2);
  EXPECT_EQ(sizes({.min_pixels = 1, .min_separation_voxels = 2}), (Sizes{100, 100, 100}));
  EXPECT_EQ(sizes({.min_pixels = 1, .min_separation_voxels = 3}), (Sizes{300}));
}

TEST_F(Motion, ClustersOfTooFewOrTooManyPixelsAreNone) {
  addSeed(1, 1);
  addSeed(5, 1);
  addSeed(6, 1);
  EXPECT_EQ(sizes({.min_pixels = 100}), (Sizes{100, 200}));
  EXPECT_EQ(sizes({.min_pixels = 101}), (Sizes{200}));
  EXPECT_EQ(sizes({.min_pixels = 1, .max_pixels = 199}), (Sizes{100}));
  EXPECT_EQ(detect({.min_pixels = 101}).ids(55, 15), 1) << "ids number what is left";
}

TEST_F(Motion, FartherThanTheRangeNothingIsLookedFor) {
  addSeed(0, 0);
  EXPECT_EQ(sizes({.min_pixels = 1, .max_range_m = 1.06}), (Sizes{100}));
  EXPECT_TRUE(sizes({.min_pixels = 1, .max_range_m = 1.04}).empty());
}

TEST_F(Motion, BeyondTwoHundredFiftyFiveClustersNoneIsListed) {
  setSize(40, 40);
  for (int i = 0; i < 400; ++i) addSeed(2 * (i % 20), 2 * (i / 20));
  const MotionDetection found = detect({.min_pixels = 1, .min_separation_voxels = 2});
  ASSERT_EQ(found.clusters.size(), 255u);
  EXPECT_EQ(std::count(found.ids.begin(), found.ids.end(), 0), (1600 - 255) * 100);
  EXPECT_EQ(found.ids(285, 245), 255) << "cluster 254 is seed (14, 12)";
  EXPECT_EQ(found.ids(305, 245), 0);
}

TEST_F(Motion, ThreadsDoNotMatter) {
  for (int i = 0; i < 12; ++i) addSeed(i, i * i % 4);
  setNumThreads(1);
  const MotionDetection one = detect({.min_pixels = 1});
  setNumThreads(4);
  const MotionDetection four = detect({.min_pixels = 1});
  setNumThreads(0);
  EXPECT_EQ(one.ids, four.ids);
  ASSERT_EQ(one.clusters.size(), four.clusters.size());
  for (std::size_t i = 0; i < one.clusters.size(); ++i) {
    EXPECT_EQ(one.clusters[i].pixels, four.clusters[i].pixels);
  }
}

TEST_F(Motion, DisabledItFindsNothingAndStillGivesAMask) {
  addSeed(1, 1);
  const MotionDetection found = detect({.enabled = false, .min_pixels = 1});
  EXPECT_TRUE(found.clusters.empty());
  EXPECT_EQ(found.ids, Image<std::uint8_t>(view_.camera.width, view_.camera.height));
}

}  // namespace
}  // namespace hydrabench

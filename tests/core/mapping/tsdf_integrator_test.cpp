// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "core/mapping/tsdf_integrator.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "core/parallel/parallel_for.h"

namespace hydrabench {
namespace {

constexpr double kFocal = 50;

/// A camera at the world's origin that looks along +z at a wall across its view, 2 m away.
Frame wall(float depth = 2) {
  Frame frame;
  frame.stamp_ns = 5;
  frame.camera = {65, 49, kFocal, kFocal, 32, 24};
  frame.depth = Image<float>(65, 49, depth);
  return frame;
}

TsdfVolume fused(const std::vector<Frame>& frames, const TsdfIntegrator::Config& config = {}) {
  TsdfVolume volume({});
  for (const Frame& frame : frames)
    TsdfIntegrator(config).integrate(sensorView(frame, 0.1, 5), volume);
  return volume;
}

/// 0 where there is no block.
float weightOf(const TsdfVolume& volume, const GlobalVoxel& at) {
  const TsdfVoxel* voxel = volume.voxel(at);
  return voxel == nullptr ? 0 : voxel->weight;
}

/// Weight of one measurement on the 0.1 m grid at depth z, before drop-off.
double weightAt(double z) { return kFocal * kFocal * 0.01 / std::pow(z, 4); }

TEST(TsdfIntegrator, MeasuresDistanceAlongTheRay) {
  const TsdfVolume volume = fused({wall()});
  // Centre (0.05, 0.05, 1.85): the wall is 2 / 1.85 times as far along its ray.
  const TsdfVoxel* near_axis = volume.voxel({0, 0, 18});
  ASSERT_NE(near_axis, nullptr);
  const double range = std::sqrt(0.05 * 0.05 * 2 + 1.85 * 1.85);
  // 0.3 mm: between pixels, ranges along a plane are not quite linear.
  EXPECT_NEAR(near_axis->distance, range * (2 / 1.85 - 1), 3e-4);
  // Off the axis it is clearly more than the distance across the wall, 0.15 m.
  const TsdfVoxel* off_axis = volume.voxel({-9, 0, 18});  // x = -0.85
  const double off_range = std::sqrt(0.85 * 0.85 + 0.05 * 0.05 + 1.85 * 1.85);
  EXPECT_NEAR(off_axis->distance, off_range * (2 / 1.85 - 1), 3e-4);
  EXPECT_GT(off_axis->distance, 0.164);
}

TEST(TsdfIntegrator, IsNegativeBehindTheSurfaceAndClippedInFront) {
  const TsdfVolume volume = fused({wall()});
  EXPECT_NEAR(volume.voxel({0, 0, 20})->distance, -0.05, 1e-3);
  EXPECT_NEAR(volume.voxel({0, 0, 21})->distance, -0.15, 1e-3);
  EXPECT_FLOAT_EQ(volume.voxel({0, 0, 5})->distance, 0.3f);
}

TEST(TsdfIntegrator, WritesNothingFarBehindTheSurface) {
  Frame frame = wall();
  frame.depth(0, 0) = 3;  // lets ranges up to 3.6 m count
  const TsdfVolume volume = fused({frame});
  EXPECT_GT(volume.voxel({0, 0, 22})->weight, 0);  // 0.25 m behind
  EXPECT_EQ(volume.voxel({0, 0, 23})->weight, 0);  // 0.35 m behind
}

TEST(TsdfIntegrator, WritesNothingBehindTheFarthestMeasurement) {
  Frame frame = wall(0);
  frame.depth(32, 24) = 2;  // one pixel on the axis measures
  const TsdfVolume volume = fused({frame}, {.interpolation = "nearest"});
  // Centre (0.05, 0.05, z) appears there from z = 5 m on only: none is measured.
  EXPECT_EQ(volume.numBlocks(), 0u);

  const TsdfVolume full = fused({wall()});
  // The farthest range of the wall is 2 m * sqrt(1 + (32^2 + 24^2) / 50^2) = 2.56 m.
  for (const BlockIndex& index : full.blockIndices()) {
    const VoxelBlock& block = *full.find(index);
    for (std::size_t i = 0; i < block.voxels.size(); ++i) {
      if (block.voxels[i].weight == 0) continue;
      EXPECT_LE(full.grid().centerOf(full.grid().globalOf(index, i)).norm(), 2.562);
    }
  }
}

TEST(TsdfIntegrator, WeighsByRayDensityOverDepthSquared) {
  const TsdfVolume volume = fused({wall()});
  // n = 50 * 50 * (0.1 / 1.85)^2 = 7.3; w = n / 1.85^2 = 2.13.
  EXPECT_NEAR(volume.voxel({0, 0, 18})->weight, weightAt(1.85), 1e-4);
  EXPECT_NEAR(weightAt(1.85), 2.134, 1e-3);
  const TsdfVolume plain = fused({wall()}, {.constant_weight = true});
  EXPECT_NEAR(plain.voxel({0, 0, 18})->weight, 7.305, 1e-3);
}

TEST(TsdfIntegrator, LetsTheWeightFallBehindTheSurface) {
  const TsdfVolume volume = fused({wall()});
  // 0.05 m behind is less than one voxel: whole. Then (0.3 + sdf) / (0.3 - 0.1).
  EXPECT_NEAR(volume.voxel({0, 0, 20})->weight, weightAt(2.05), 1e-4);
  const TsdfVoxel* behind = volume.voxel({0, 0, 21});
  EXPECT_NEAR(behind->weight, weightAt(2.15) * (0.3 + behind->distance) / 0.2, 1e-4);
  EXPECT_NEAR(behind->weight / weightAt(2.15), 0.75, 0.01);
  const TsdfVolume whole = fused({wall()}, {.weight_dropoff = false});
  EXPECT_NEAR(whole.voxel({0, 0, 21})->weight, weightAt(2.15), 1e-4);
}

TEST(TsdfIntegrator, KeepsWeightsWithinTheirLimits) {
  const TsdfVolume volume = fused({wall(), wall()}, {.min_weight = 2, .max_weight = 5});
  EXPECT_FLOAT_EQ(volume.voxel({0, 0, 21})->weight, 4);  // 0.88 raised to 2, twice
  EXPECT_FLOAT_EQ(volume.voxel({0, 0, 10})->weight, 5);
}

TEST(TsdfIntegrator, FusesToTheWeightedMean) {
  const TsdfVolume first = fused({wall(2.0f)}, {.max_range_difference_m = 1});
  const TsdfVolume second = fused({wall(2.1f)}, {.max_range_difference_m = 1});
  const TsdfVolume both = fused({wall(2.0f), wall(2.1f)}, {.max_range_difference_m = 1});
  for (const int z : {18, 19, 20, 21, 22}) {
    const TsdfVoxel& a = *first.voxel({1, -2, z});
    const TsdfVoxel& b = *second.voxel({1, -2, z});
    const TsdfVoxel& mean = *both.voxel({1, -2, z});
    EXPECT_NEAR(mean.distance,
                (a.distance * a.weight + b.distance * b.weight) / (a.weight + b.weight), 1e-6);
    EXPECT_FLOAT_EQ(mean.weight, a.weight + b.weight);
  }
}

TEST(TsdfIntegrator, TakesTheFirstColorWholeAndThenTheMean) {
  Frame red = wall();
  red.color = Image<Rgb>(65, 49, Rgb{200, 0, 100});
  Frame blue = wall();
  blue.color = Image<Rgb>(65, 49, Rgb{0, 100, 100});
  Frame farther = wall(4);  // carves the voxel free without giving it a colour
  farther.color = Image<Rgb>(65, 49, Rgb{255, 255, 255});
  const GlobalVoxel at(0, 0, 19);
  EXPECT_FALSE(fused({farther}).voxel(at)->colored);
  EXPECT_EQ(fused({farther, red}).voxel(at)->color, (Rgb{200, 0, 100}));
  EXPECT_EQ(fused({red, blue}).voxel(at)->color, (Rgb{100, 50, 100}));  // equal weights
  EXPECT_EQ(fused({red, red, red, blue}).voxel(at)->color, (Rgb{150, 25, 100}));
}

TEST(TsdfIntegrator, ColoursAndLabelsOnlyTheBand) {
  Frame frame = wall();
  frame.color = Image<Rgb>(65, 49, Rgb{9, 9, 9});
  frame.labels = Image<Label>(65, 49, 3);
  const TsdfVolume volume = fused({frame});
  const auto label = [&](int z) {
    const GlobalVoxel at(0, 0, z);
    const VoxelBlock& block = *volume.find(volume.grid().blockOf(at));
    return block.semantics->label(volume.grid().localOf(at));
  };
  EXPECT_EQ(label(19), 3);
  EXPECT_EQ(label(21), 3);
  EXPECT_EQ(label(15), std::nullopt);  // 0.45 m in front
  EXPECT_TRUE(volume.voxel({0, 0, 19})->colored);
  EXPECT_FALSE(volume.voxel({0, 0, 15})->colored);
}

TEST(TsdfIntegrator, ChoosesLabelsByTheSumOfWeightsAndNeverBlends) {
  Frame frame = wall();
  frame.labels = Image<Label>(65, 49, 2);
  // Centre (0.05, 0.05, 1.95) appears at (33.28, 25.28): weights 0.52, 0.20, 0.20, 0.08.
  frame.labels(33, 25) = 8;
  const GlobalVoxel at(0, 0, 19);
  const auto labelOf = [&](const TsdfVolume& volume) {
    return volume.find({0, 0, 1})->semantics->label(volume.grid().localOf(at));
  };
  EXPECT_EQ(labelOf(fused({frame})), 8);
  frame.labels(33, 25) = 2;
  frame.labels(34, 25) = 8;
  frame.labels(33, 26) = 8;
  EXPECT_EQ(labelOf(fused({frame})), 2);  // 0.60 against 0.40

  // Centre (0.05, 0.05, 1.75) appears at (33.43, 25.43): 0.33, 0.24, 0.24, 0.19.
  Frame three = wall();
  three.labels = Image<Label>(65, 49, 2);
  three.labels(33, 25) = 8;
  const TsdfVolume volume = fused({three});
  EXPECT_EQ(volume.find({0, 0, 1})->semantics->label(volume.grid().localOf({0, 0, 17})), 2);
}

TEST(TsdfIntegrator, CarvesInFrontOfMaskedPixelsButDoesNotFillThem) {
  const Frame frame = wall();
  const Image<std::uint8_t> mask(65, 49, 1);
  SensorView view = sensorView(frame, 0.1, 5);
  view.mask = &mask;
  TsdfVolume volume({});
  TsdfIntegrator({}).integrate(view, volume);
  EXPECT_FLOAT_EQ(volume.voxel({0, 0, 15})->distance, 0.3f);
  EXPECT_GT(volume.voxel({0, 0, 15})->weight, 0);
  EXPECT_EQ(volume.voxel({0, 0, 18})->weight, 0);
  EXPECT_EQ(volume.voxel({0, 0, 20})->weight, 0);
}

TEST(TsdfIntegrator, LearnsNothingFromPixelsWithoutDepth) {
  Frame frame = wall();
  for (int v = 0; v < 49; ++v)
    for (int u = 0; u < 33; ++u) frame.depth(u, v) = u % 2 ? 0 : std::nanf("");
  for (const char* interpolation : {"nearest", "bilinear", "adaptive"}) {
    const TsdfVolume volume = fused({frame}, {.interpolation = interpolation});
    EXPECT_GT(weightOf(volume, {2, 0, 19}), 0) << interpolation;
    EXPECT_EQ(weightOf(volume, {-3, 0, 19}), 0) << interpolation;
    EXPECT_EQ(weightOf(volume, {-2, 0, 5}), 0) << interpolation;
  }
  EXPECT_EQ(fused({wall(0)}).numBlocks(), 0u);
}

TEST(TsdfIntegrator, InterpolatesWhereRangesAgreeOnly) {
  // Centre (0.05, 0.05, 1.95) appears at (33.28, 25.28).
  Frame frame = wall();
  frame.depth(34, 25) = 2.1f;
  const GlobalVoxel at(0, 0, 19);
  const double range = std::sqrt(0.05 * 0.05 * 2 + 1.95 * 1.95);
  const float level = fused({wall()}).voxel(at)->distance;
  const float nearest = fused({frame}, {.interpolation = "nearest"}).voxel(at)->distance;
  const float blended = fused({frame}).voxel(at)->distance;
  EXPECT_NEAR(nearest, 2 * std::sqrt(1 + 2 * 0.02 * 0.02) - range, 1e-5);  // pixel (33, 25)
  const double weight = (0.05 / 1.95 * 50 - 1) * (2 - 0.05 / 1.95 * 50);
  EXPECT_NEAR(blended - level, weight * 0.1, 2e-3);
  frame.depth(34, 25) = 2.5f;
  EXPECT_EQ(fused({frame}).voxel(at)->distance, nearest);
  EXPECT_NEAR(fused({frame}, {.interpolation = "bilinear"}).voxel(at)->distance - level,
              std::min(weight * 0.5, 0.3 - level), 2e-3);
}

TEST(TsdfIntegrator, DoesNotInterpolateAcrossAHole) {
  // Centre (0.05, 0.05, 1.45) appears at (33.72, 25.72): the nearest pixel is (34, 26).
  Frame frame = wall();
  frame.depth(34, 25) = 0;
  const GlobalVoxel at(0, 0, 14);
  EXPECT_EQ(weightOf(fused({frame}, {.interpolation = "bilinear"}), at), 0);
  EXPECT_GT(weightOf(fused({frame}), at), 0);
  EXPECT_GT(weightOf(fused({frame}, {.max_range_difference_m = 100}), at), 0);
  frame.depth(34, 26) = 0;
  EXPECT_EQ(weightOf(fused({frame}), at), 0);
}

/// A box in front of a wall with holes, seen from a place below zero, turned.
Frame scenery(int step) {
  Frame frame = wall(3);
  frame.stamp_ns = 100 + step;
  for (int v = 10; v < 35; ++v)
    for (int u = 12; u < 40; ++u) frame.depth(u, v) = 1.2f + 0.01f * static_cast<float>(u);
  for (int v = 40; v < 46; ++v)
    for (int u = 50; u < 60; ++u) frame.depth(u, v) = 0;
  frame.color = Image<Rgb>(65, 49);
  frame.labels = Image<Label>(65, 49);
  for (int v = 0; v < 49; ++v) {
    for (int u = 0; u < 65; ++u) {
      frame.color(u, v) = {static_cast<std::uint8_t>(3 * u), static_cast<std::uint8_t>(5 * v), 77};
      frame.labels(u, v) = u / 10 + v / 10;
    }
  }
  frame.T_world_camera = lookAt({-1.3, 0.4 + 0.1 * step, -0.7}, {2, -1 - 0.2 * step, 0.3});
  return frame;
}

void expectSame(const TsdfVolume& a, const TsdfVolume& b, const BlockIndex& index) {
  const VoxelBlock& x = *a.find(index);
  const VoxelBlock& y = *b.find(index);
  EXPECT_EQ(x.last_updated_ns, y.last_updated_ns);
  EXPECT_EQ(x.mesh_outdated, y.mesh_outdated);
  for (std::size_t i = 0; i < x.voxels.size(); ++i) {
    ASSERT_EQ(x.voxels[i].distance, y.voxels[i].distance) << index.transpose() << ", voxel " << i;
    ASSERT_EQ(x.voxels[i].weight, y.voxels[i].weight);
    ASSERT_EQ(x.voxels[i].color, y.voxels[i].color);
    ASSERT_EQ(x.semantics->label(i), y.semantics->label(i));
  }
}

/// Small ones, so that many lie wholly in front of or behind what is seen.
TsdfVolume::Config blocksOf(int side, double voxel_size_m) {
  return {.voxel_size_m = voxel_size_m,
          .truncation_m = 3 * voxel_size_m,
          .voxels_per_side = side,
          .semantics = {}};
}

/// Fuses a view twice, once with what tiles decide early and once voxel by voxel, into every block
/// around.
void expectEarlyDecisionsChangeNothing(const SensorView& view, const TsdfVolume::Config& config) {
  TsdfVolume fast(config);
  TsdfVolume plain(config);
  const int radius = static_cast<int>(3.6 / plain.grid().blockSize());
  const BlockIndex middle = plain.grid().blockAt(view.T_world_sensor.translation());
  std::vector<BlockIndex> around;
  for (int x = -radius; x <= radius; ++x)
    for (int y = -radius; y <= radius; ++y)
      for (int z = -radius; z <= radius; ++z) around.push_back(middle + BlockIndex(x, y, z));
  for (const BlockIndex& index : around) plain.allocate(index);
  SensorView without_tiles = view;
  without_tiles.tiles = {};

  TsdfIntegrator({}).integrate(view, fast);
  TsdfIntegrator({}).integrateBlocks(without_tiles, around, plain);
  std::size_t num_measured = 0;
  for (const BlockIndex& index : around) {
    const auto& voxels = plain.find(index)->voxels;
    if (std::none_of(voxels.begin(), voxels.end(), [](const auto& v) { return v.weight > 0; })) {
      EXPECT_EQ(fast.find(index), nullptr);
      continue;
    }
    ++num_measured;
    ASSERT_NE(fast.find(index), nullptr) << index.transpose();
    expectSame(fast, plain, index);
  }
  EXPECT_EQ(num_measured, fast.numBlocks());
  EXPECT_GT(num_measured, 30u);
}

TEST(TsdfIntegrator, DecidesEarlyAboutBlocksWithoutChangingABit) {
  const Frame cluttered = scenery(1);
  expectEarlyDecisionsChangeNothing(sensorView(cluttered, 0.5, 3.2), blocksOf(8, 0.1));
  expectEarlyDecisionsChangeNothing(sensorView(cluttered, 0.5, 3.2), blocksOf(8, 0.04));
}

TEST(TsdfIntegrator, DecidesEarlyAboutTinyBlocksWithoutChangingABit) {
  // Tiny blocks before a plain wall: some end just within each limit, some just beyond.
  Frame plain = wall();
  plain.T_world_camera = lookAt({0.3, -0.2, 0.1}, {2, 1, 0.4});
  SensorView view = sensorView(plain, 0.8, 5);
  expectEarlyDecisionsChangeNothing(view, blocksOf(3, 0.1));
  view.max_range_m = 1.5;  // below what was measured
  expectEarlyDecisionsChangeNothing(view, blocksOf(3, 0.1));
}

TEST(TsdfIntegrator, GivesTheSameBytesForAnyNumberOfThreads) {
  const auto run = [](int num_threads) {
    setNumThreads(num_threads);
    TsdfVolume volume(blocksOf(8, 0.05));
    std::vector<BlockIndex> changed;
    for (int step = 0; step < 3; ++step)
      changed = TsdfIntegrator({}).integrate(sensorView(scenery(step), 0.1, 5), volume);
    setNumThreads(0);
    return std::pair(std::move(volume), changed);
  };
  const auto [one, changed_by_one] = run(1);
  const auto [four, changed_by_four] = run(4);
  EXPECT_EQ(changed_by_one, changed_by_four);
  ASSERT_EQ(one.blockIndices(), four.blockIndices());
  for (const BlockIndex& index : one.blockIndices()) expectSame(one, four, index);
}

TEST(TsdfIntegrator, ListsWhatChangedInOrderAndKeepsNoBlockWithoutMeasurement) {
  TsdfVolume volume({});
  const std::vector<BlockIndex> changed =
      TsdfIntegrator({}).integrate(sensorView(wall(), 0.1, 5), volume);
  EXPECT_TRUE(std::is_sorted(changed.begin(), changed.end(), IndexLess{}));
  EXPECT_EQ(changed, volume.blockIndices());
  for (const BlockIndex& index : changed) {
    const VoxelBlock& block = *volume.find(index);
    EXPECT_EQ(block.last_updated_ns, 5);
    EXPECT_TRUE(block.mesh_outdated);
    EXPECT_TRUE(std::any_of(block.voxels.begin(), block.voxels.end(),
                            [](const auto& v) { return v.weight > 0; }));
  }
}

TEST(TsdfIntegrator, UpdatesTheGivenBlocksAndNoOthers) {
  TsdfVolume volume({});
  volume.allocate({0, 0, 1});
  volume.allocate({0, 0, -9});  // behind the camera
  TsdfIntegrator({}).integrateBlocks(sensorView(wall(), 0.1, 5), volume.blockIndices(), volume);
  EXPECT_EQ(volume.numBlocks(), 2u);
  EXPECT_GT(volume.voxel({0, 0, 19})->weight, 0);
  EXPECT_FALSE(volume.find({0, 0, -9})->mesh_outdated);
}

}  // namespace
}  // namespace hydrabench

// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include <cmath>
#include <map>
#include <numbers>

#include <gtest/gtest.h>

#include "core/mapping/tsdf_integrator.h"

namespace hydrabench {
namespace {

constexpr double kDegree = std::numbers::pi / 180;

/// A lidar at the origin that sees a wall of ranges 6 m all around, and beyond it at one place, so
/// that ranges up to 20 m count.
struct RoundWall {
  RoundWall() : ground(361, 16, 1) {
    view.lidar = LidarModel{
        .columns = 360, .rows = 16, .top_rad = 15 * kDegree, .bottom_rad = -15 * kDegree};
    view.range = Image<float>(361, 16, 6);
    view.range(20, 0) = 20;
    view.min_range_m = 0.4;
    view.max_range_m = 40;
    view.ground = &ground;
    summarizeRange(view);
  }
  RoundWall(const RoundWall&) = delete;
  SensorView view;
  Image<std::uint8_t> ground;
};

constexpr double kVoxel = 0.2;
constexpr double kTruncation = 0.4;

TsdfVolume fused(const SensorView& view, double extra_m, double weight = 1e-3) {
  TsdfVolume::Config grid;
  grid.voxel_size_m = kVoxel;
  grid.truncation_m = kTruncation;
  TsdfVolume volume(grid);
  TsdfIntegrator::Config config;
  config.constant_weight = true;
  config.ground_band = {.extra_m = extra_m, .weight = weight, .between_rows = false};
  TsdfIntegrator(config).integrate(view, volume);
  return volume;
}

/// The voxel of the row y = z = 0.1 m whose centre is at x.
const TsdfVoxel& at(const TsdfVolume& volume, double x) {
  static const TsdfVoxel kNever;
  const TsdfVoxel* voxel = volume.voxel({static_cast<int>(std::floor(x / kVoxel)), 0, 0});
  return voxel ? *voxel : kNever;
}

TEST(GroundBand, WritesTheLowerEndOfTheBandBehindGroundWithItsOwnWeight) {
  const RoundWall wall;
  const TsdfVolume volume = fused(wall.view, 3);
  for (const double x : {6.5, 7.1, 8.1, 9.3}) {  // up to 6 + 0.4 + 3 m
    EXPECT_FLOAT_EQ(at(volume, x).distance, -0.4f) << x;
    EXPECT_FLOAT_EQ(at(volume, x).weight, 1e-3f) << x;
  }
  EXPECT_EQ(at(volume, 9.5).weight, 0);
}

TEST(GroundBand, ChangesNothingInFrontNorWithinTheTruncationDistance) {
  const RoundWall wall;
  const TsdfVolume with = fused(wall.view, 3);
  const TsdfVolume without = fused(wall.view, 0);
  for (double x = 0.5; x < 6.4; x += kVoxel) {
    EXPECT_EQ(at(with, x).distance, at(without, x).distance) << x;
    EXPECT_EQ(at(with, x).weight, at(without, x).weight) << x;
    EXPECT_GT(at(with, x).weight, 0) << x;
  }
  EXPECT_EQ(at(without, 6.5).weight, 0);
}

TEST(GroundBand, LeavesEverythingElseAloneThatIsNotGround) {
  RoundWall wall;
  wall.ground.fill(0);
  const TsdfVolume with = fused(wall.view, 3);
  const TsdfVolume without = fused(wall.view, 0);
  EXPECT_EQ(with.blockIndices(), without.blockIndices());
  EXPECT_EQ(at(with, 7.1).weight, 0);
  EXPECT_GT(at(with, 5.9).weight, 0);
  wall.view.ground = nullptr;
  EXPECT_EQ(fused(wall.view, 3).blockIndices(), without.blockIndices());
}

TEST(GroundBand, WritesNothingBehindMovingGround) {
  RoundWall wall;
  const Image<std::uint8_t> moving(361, 16, 1);
  wall.view.mask = &moving;
  EXPECT_EQ(at(fused(wall.view, 3), 7.1).weight, 0);
}

TEST(GroundBand, LeavesNoTraceWhereSomethingIsTrulySeen) {
  const RoundWall wall;
  RoundWall farther;  // sees free space, and a surface, where the band was
  farther.view.range = Image<float>(361, 16, 8);
  farther.view.range(20, 0) = 20;
  farther.ground.fill(0);
  summarizeRange(farther.view);
  TsdfIntegrator::Config config;
  config.constant_weight = true;
  config.ground_band = {.extra_m = 3, .weight = 10, .between_rows = false};
  const TsdfIntegrator with_band(config);
  TsdfVolume after = fused(wall.view, 3, 10);
  with_band.integrate(farther.view, after);
  TsdfVolume before = fused(farther.view, 0);
  with_band.integrate(wall.view, before);
  const TsdfVolume alone = fused(farther.view, 0);
  for (double x = 6.5; x < 8.4; x += kVoxel) {
    EXPECT_EQ(at(after, x).distance, at(alone, x).distance) << x;
    EXPECT_EQ(at(after, x).weight, at(alone, x).weight) << x;
    EXPECT_EQ(at(before, x).distance, at(alone, x).distance) << x;
    EXPECT_EQ(at(before, x).weight, at(alone, x).weight) << x;
    EXPECT_GT(at(alone, x).weight, 0) << x;
  }
  EXPECT_EQ(at(after, 9.1).distance, -0.4f);  // nothing else there
}

/// A lidar 0.5 m above flat ground, rows a degree apart: they meet it 14.3 m and 28.6 m away, and
/// nearer.
struct FlatGround {
  static constexpr double kHeight = 0.5;
  FlatGround() : ground(361, 16, 0) {
    view.lidar = LidarModel{.columns = 360, .rows = 16, .top_rad = 0, .bottom_rad = -15 * kDegree};
    view.range = Image<float>(361, 16, 0);
    for (int v = 1; v < 16; ++v) {
      for (int u = 175; u < 186; ++u) {  // to the front
        view.range(u, v) = static_cast<float>(kHeight / std::sin(v * kDegree));
        ground(u, v) = 1;
      }
    }
    view.min_range_m = 0.4;
    view.max_range_m = 16;
    view.ground = &ground;
    summarizeRange(view);
  }
  FlatGround(const FlatGround&) = delete;

  /// @param lost  whether a row has no return
  /// @param off   see SensorView::row_offset
  template <typename Lost, typename Off>
  void setRows(const Lost& lost, const Off& off) {
    offset = Image<float>(361, 16, 0);
    for (int v = 1; v < 16; ++v) {
      for (int u = 175; u < 186; ++u) {
        offset(u, v) = off(v);
        const double down = (v + off(v)) * kDegree;
        view.range(u, v) = lost(v) ? 0.0f : static_cast<float>(kHeight / std::sin(down));
      }
    }
    view.row_offset = &offset;
    summarizeRange(view);
  }

  TsdfVolume fused(bool between_rows, double max_range_m = 30) const {
    TsdfVolume::Config grid;
    grid.voxel_size_m = 0.05;
    grid.truncation_m = kTruncation;
    TsdfVolume volume(grid);
    TsdfIntegrator::Config config;
    config.constant_weight = true;
    config.ground_band = {.extra_m = 3, .between_rows = between_rows, .max_range_m = max_range_m};
    TsdfIntegrator(config).integrate(view, volume);
    return volume;
  }
  /// The measured voxels of the column over (x, 0), by height above the ground.
  static std::map<double, double> column(const TsdfVolume& volume, double x) {
    const double size = volume.grid().voxel_size;
    std::map<double, double> distances;
    for (double z = -kHeight - 0.5; z < 0; z += size) {
      const TsdfVoxel* voxel = volume.voxel(
          {static_cast<int>(std::floor(x / size)), 0, static_cast<int>(std::floor(z / size))});
      const double above = (std::floor(z / size) + 0.5) * size + kHeight;
      if (voxel != nullptr && voxel->weight > 0) distances[above] = voxel->distance;
    }
    return distances;
  }

  /// That every distance between two x is that to the ground, below the first row that met it.
  static void expectHeights(const TsdfVolume& volume, double low_x, double high_x) {
    for (double x = low_x; x < high_x; x += 0.05) {
      const auto distances = column(volume, x);
      EXPECT_GT(distances.size(), 4u) << x;
      for (const auto& [above, distance] : distances) {
        if (std::atan2(kHeight - above, x) < 1.02 * kDegree) continue;
        EXPECT_NEAR(distance, std::clamp(above, -kTruncation, kTruncation), 2e-3)
            << "at " << x << ", " << above << " m above the ground";
      }
    }
  }

  SensorView view;
  Image<std::uint8_t> ground;
  Image<float> offset;
};

TEST(GroundBand, TellsAboveFromBelowBetweenTwoRowsOfALidar) {
  const FlatGround scene;
  const TsdfVolume plane = scene.fused(true);
  const TsdfVolume nearest = scene.fused(false);
  int wrong = 0;
  // From the row at 4.1 m to that at 14.3 m, of 7 to 15 m apart.
  for (double x = 4.5; x < 14; x += 0.05) {
    const auto distances = FlatGround::column(plane, x);
    EXPECT_GT(distances.size(), 4u) << x;
    for (const auto& [above, distance] : distances) {
      const double angle = std::atan2(FlatGround::kHeight - above, x);
      if (std::abs(angle - kDegree) < 0.02 * kDegree) continue;  // at the first row that met it
      const bool below_first_row = angle > kDegree;
      EXPECT_NEAR(distance,
                  below_first_row ? std::clamp(above, -kTruncation, kTruncation) : kTruncation,
                  2e-3)
          << "at " << x << ", " << above << " m above the ground";
    }
    for (const auto& [above, distance] : FlatGround::column(nearest, x)) {
      wrong += distance > 0 && above < 0;
    }
  }
  EXPECT_GT(wrong, 50);
}

TEST(GroundBand, ReachesAsFarAsTheBandBehindTheFartherOfTwoRows) {
  const FlatGround scene;
  // 12 m away, a voxel 0.13 to 0.33 m below the ground lies between the rows that met it at 9.55
  // and 7.17 m. From 0.23 m on the latter is nearer, and 12 m is more than 3.4 m behind it.
  const auto reach = [&](bool between_rows) {
    const auto distances = FlatGround::column(scene.fused(between_rows), 12);
    return distances.empty() ? 0.0 : distances.begin()->first;
  };
  EXPECT_NEAR(reach(true), -0.34, 0.025);
  EXPECT_NEAR(reach(false), -0.23, 0.025);
}

TEST(GroundBand, TakesTheNearerRowWhereTheOtherOneDidNotMeetGroundButFreesNothingBelowIt) {
  FlatGround scene;
  for (int v = 0; v < 16; v += 2) {
    for (int u = 0; u < 361; ++u) scene.ground(u, v) = 0;
  }
  const TsdfVolume plane = scene.fused(true);
  const TsdfVolume nearest = scene.fused(false);
  int below = 0;
  for (double x = 3; x < 14; x += 0.5) {
    auto distances = FlatGround::column(nearest, x);
    below += static_cast<int>(std::erase_if(
        distances, [](const auto& voxel) { return voxel.first < 0 && voxel.second > 0; }));
    EXPECT_EQ(FlatGround::column(plane, x), distances) << x;
  }
  EXPECT_GT(below, 5);
}

TEST(GroundBand, PassesOverRowsWithoutAReturn) {
  FlatGround scene;
  scene.setRows([](int v) { return v == 4 || v == 6 || v == 7 || v == 8; },
                [](int) { return 0.0f; });
  // The row of 3 degrees meets the ground 9.5 m away, that of 9 degrees 3.2 m.
  FlatGround::expectHeights(scene.fused(true), 4, 9);
  scene.setRows([](int v) { return v > 3 && v < 8; }, [](int) { return 0.0f; });
  EXPECT_LT(FlatGround::column(scene.fused(true), 6).size(),
            FlatGround::column(FlatGround().fused(true), 6).size());
}

TEST(GroundBand, GoesThroughTheRaysAndNotTheMiddlesOfRows) {
  FlatGround scene;
  scene.setRows([](int) { return false; },
                [](int v) { return v % 3 == 0   ? 0.45f
                                   : v % 3 == 1 ? -0.4f
                                                : 0.1f; });
  FlatGround::expectHeights(scene.fused(true), 7, 11);
  scene.view.row_offset = nullptr;
  double worst = 0;
  for (const auto& [above, distance] : FlatGround::column(scene.fused(true), 8)) {
    worst = std::max(worst, std::abs(distance - std::clamp(above, -kTruncation, kTruncation)));
  }
  EXPECT_GT(worst, 0.03);
}

TEST(GroundBand, SaysNothingOfGroundBeyondItsRange) {
  const FlatGround scene;
  const TsdfVolume near = scene.fused(true, 8);
  const TsdfVolume all = scene.fused(true, 20);
  EXPECT_EQ(FlatGround::column(near, 7), FlatGround::column(all, 7));
  for (const auto& [above, distance] : FlatGround::column(near, 10)) {
    EXPECT_GT(above, kTruncation - 0.05);
    EXPECT_FLOAT_EQ(static_cast<float>(distance), static_cast<float>(kTruncation));
  }
  EXPECT_LT(FlatGround::column(all, 10).begin()->first, -0.1);
}

TEST(GroundBand, BetweenRowsIsTheSameWhetherDecidedEarlyOrVoxelByVoxel) {
  FlatGround scene;
  const TsdfVolume early = scene.fused(true);
  scene.view.tiles = {};
  const TsdfVolume plain = scene.fused(true);
  EXPECT_EQ(early.blockIndices(), plain.blockIndices());
  for (double x = 1; x < 16; x += 0.25) {
    EXPECT_EQ(FlatGround::column(early, x), FlatGround::column(plain, x)) << x;
  }
}

TEST(GroundBand, IsTheSameWhetherDecidedEarlyOrVoxelByVoxel) {
  RoundWall wall;
  for (int u = 0; u < 361; ++u) wall.ground(u, 9) = 0;
  wall.view.range(100, 7) = 0;
  summarizeRange(wall.view);
  const TsdfVolume early = fused(wall.view, 3);
  wall.view.tiles = {};
  const TsdfVolume plain = fused(wall.view, 3);
  ASSERT_EQ(early.blockIndices(), plain.blockIndices());
  std::size_t measured = 0;
  for (const BlockIndex& index : early.blockIndices()) {
    const VoxelBlock& a = *early.find(index);
    const VoxelBlock& b = *plain.find(index);
    for (std::size_t i = 0; i < a.voxels.size(); ++i) {
      ASSERT_EQ(a.voxels[i].distance, b.voxels[i].distance);
      ASSERT_EQ(a.voxels[i].weight, b.voxels[i].weight);
      measured += a.voxels[i].weight > 0;
    }
  }
  EXPECT_GT(measured, 10000u);
}

TEST(LidarIntegration, WeighsByRaysThatMeetTheVoxel) {
  const RoundWall wall;
  const TsdfVolume volume = fused(wall.view, 0);
  const double range = std::sqrt(5.1 * 5.1 + 2 * 0.1 * 0.1);
  const double rays = (360 / (2 * std::numbers::pi)) * (15 / (30 * kDegree));
  EXPECT_NEAR(at(volume, 5.1).weight, rays * kVoxel * kVoxel / (range * range), 1e-4);
  EXPECT_NEAR(at(volume, 5.9).distance, 6 - std::sqrt(5.9 * 5.9 + 0.02), 1e-5);
}

TEST(LidarIntegration, GoesAcrossTheSeamAtTheBack) {
  const RoundWall wall;
  const TsdfVolume volume = fused(wall.view, 0);
  for (const int y : {-1, 0}) {
    const TsdfVoxel* behind = volume.voxel({-30, y, 0});  // x = -5.9
    ASSERT_NE(behind, nullptr);
    EXPECT_NEAR(behind->distance, 6 - std::sqrt(5.9 * 5.9 + 0.02), 1e-5);
  }
}

}  // namespace
}  // namespace hydrabench

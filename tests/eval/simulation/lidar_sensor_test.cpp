// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/simulation/lidar_sensor.h"

#include <cmath>
#include <map>
#include <numbers>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/parallel/parallel_for.h"
#include "core/types/error.h"
#include "eval/simulation/lidar_pattern.h"
#include "tests/eval/simulation/simple_scenes.h"

namespace hydrabench {
namespace {

using ::testing::HasSubstr;

constexpr double kDegree = std::numbers::pi / 180;
constexpr std::int64_t kTurn_ns = 100'000'000;
/// Of the grey of structureBox(): 180 of 255 in linear light (IEC 61966-2-1).
const double kGrey = std::pow((180 / 255.0 + 0.055) / 1.055, 2.4);

RgbdRenderer render(std::vector<StructurePart> structure) {
  Scene scene;
  scene.structure = std::move(structure);
  return RgbdRenderer(std::make_shared<const Scene>(std::move(scene)));
}

StructurePart box(Label label, const Eigen::Vector3d& low, const Eigen::Vector3d& high) {
  return structureBox("box", label, Aabb(low, high));
}
StructurePart floorPart() { return box(office_label::kFloor, {-200, -200, -1}, {200, 200, 0}); }
/// Its face at x = 10 looks back.
StructurePart wallAhead() { return box(office_label::kWall, {10, -50, -1}, {11, 50, 30}); }

const std::vector<TimedPose> kStandstill = {{0, Transform::Identity()},
                                            {kTurn_ns, Transform::Identity()}};

LidarScan turn(const RgbdRenderer& world, const LidarSensorConfig& config,
               const std::vector<TimedPose>& poses = kStandstill, std::uint64_t seed = 1) {
  return sweep(world, poses, config.ego_motion ? 0 : kTurn_ns, kTurn_ns, config, seed);
}

LidarSensorConfig clean(const std::string& pattern = "vlp16") {
  return LidarSensorConfig::forPattern(pattern, "clean");
}

TEST(LidarPattern, ElevationsAreThoseOfTheDataSheets) {
  const LidarPattern vlp16 = LidarPattern::vlp16();
  ASSERT_EQ(vlp16.elevations_rad.size(), 16u);
  for (std::size_t i = 0; i < 16; ++i) {
    EXPECT_NEAR(vlp16.elevations_rad[i] / kDegree, 15 - 2.0 * static_cast<double>(i), 1e-12);
  }
  const LidarPattern hdl64 = LidarPattern::hdl64();
  ASSERT_EQ(hdl64.elevations_rad.size(), 64u);
  EXPECT_NEAR(hdl64.elevations_rad[0] / kDegree, 2, 1e-12);
  EXPECT_NEAR(hdl64.elevations_rad[31] / kDegree, -8 - 1.0 / 3, 1e-12);
  EXPECT_NEAR(hdl64.elevations_rad[32] / kDegree, -8.83, 0.005);
  EXPECT_NEAR(hdl64.elevations_rad[63] / kDegree, -24.33, 0.005);
  EXPECT_EQ(hdl64.model().rows, 64);
  EXPECT_EQ(hdl64.model().columns, 1800);
}

TEST(LidarSensor, AFlatFloorIsHitAtHeightOverSineOfElevation) {
  for (const char* pattern : {"vlp16", "hdl64"}) {
    const LidarScan scan = turn(render({floorPart()}), clean(pattern));
    const LidarPattern lasers = lidarPattern(pattern);
    std::map<std::uint16_t, int> per_ring;
    for (std::size_t i = 0; i < scan.points.size(); ++i) {
      const double range = 0.5 / std::sin(-lasers.elevations_rad.at(scan.rings[i]));
      ASSERT_NEAR(scan.points[i].norm(), range, 1e-5 * range);
      ASSERT_NEAR(scan.points[i].z(), -0.5, 1e-5 * range);
      ++per_ring[scan.rings[i]];
    }
    std::size_t rings_on_floor = 0;
    for (std::size_t ring = 0; ring < lasers.elevations_rad.size(); ++ring) {
      const bool hits = 0.5 < -std::sin(lasers.elevations_rad[ring]) *
                                  LidarSensorConfig::forPattern(pattern, "clean").max_range_m;
      rings_on_floor += hits;
      EXPECT_EQ(per_ring[static_cast<std::uint16_t>(ring)], hits ? 1800 : 0) << pattern << ring;
    }
    EXPECT_EQ(scan.points.size(), 1800 * rings_on_floor);
  }
}

TEST(LidarSensor, APointLiesInTheColumnOfItsTimeAndTheRowOfItsLaser) {
  const LidarScan scan = turn(render({floorPart(), wallAhead()}), clean());
  ASSERT_GT(scan.points.size(), 15000u);
  for (std::size_t i = 0; i < scan.points.size(); i += 7) {
    const Eigen::Vector3d expected =
        scan.lidar.direction(double{scan.times[i]} * 1800, scan.rings[i]);
    ASSERT_LT((scan.points[i].cast<double>().normalized() - expected).norm(), 1e-6);
  }
}

TEST(LidarSensor, TheMountIsRollThenPitchThenYawAboveTheGround) {
  LidarSensorConfig config = clean();
  config.translation_m = {0.2, 0, 1.5};
  config.yaw_deg = 90;
  config.pitch_deg = 10;  // down where the sensor looks: to the left of the robot
  const LidarScan scan = turn(render({floorPart()}), config);
  const Transform T_body_lidar = config.T_body_lidar();
  EXPECT_TRUE((T_body_lidar.linear() * Eigen::Vector3d::UnitX())
                  .isApprox(Eigen::Vector3d(0, std::cos(10 * kDegree), -std::sin(10 * kDegree))));
  for (const Eigen::Vector3f& point : scan.points) {
    ASSERT_NEAR((T_body_lidar * point.cast<double>()).z(), 0, 2e-3);
  }
  // The lowest laser straight ahead goes down by 25 degrees now.
  bool found = false;
  for (std::size_t i = 0; i < scan.points.size(); ++i) {
    if (scan.rings[i] != 15 || scan.times[i] != 0.5f) continue;
    found = true;
    EXPECT_NEAR(scan.points[i].norm(), 1.5 / std::sin(25 * kDegree), 1e-4);
  }
  EXPECT_TRUE(found);
}

TEST(LidarSensor, RangesScatterAsConfiguredInStepsOfTheQuantum) {
  LidarSensorConfig config = clean();
  config.range_noise_m = 0.03;
  config.range_quantum_m = 0.002;
  const LidarScan scan = turn(render({wallAhead()}), config);
  double sum = 0, squares = 0;
  for (std::size_t i = 0; i < scan.points.size(); ++i) {
    const Eigen::Vector3d p = scan.points[i].cast<double>();
    const double error = p.norm() * (1 - 10 / p.x());
    sum += error;
    squares += error * error;
    const double steps = p.norm() / 0.002;
    ASSERT_NEAR(steps, std::round(steps), 0.01);
  }
  const auto count = static_cast<double>(scan.points.size());
  ASSERT_GT(count, 3000);
  EXPECT_NEAR(sum / count, 0, 0.003);
  EXPECT_NEAR(std::sqrt(squares / count), 0.03, 0.002);
}

TEST(LidarSensor, WhatIsNearerThanTheLeastRangeReturnsNothingAndHidesWhatIsBehind) {
  LidarSensorConfig config = clean();
  config.min_range_m = 2;
  const LidarScan scan =
      turn(render({wallAhead(), box(office_label::kWall, {1, -50, -5}, {1.1, 50, 30})}), config);
  for (const Eigen::Vector3f& point : scan.points) {
    EXPECT_NEAR(point.x(), 1, 1e-4);
    EXPECT_GE(point.norm(), 2);
  }
  EXPECT_FALSE(scan.points.empty());
}

TEST(LidarSensor, AReturnIsLostWhereReflectanceTimesCosineOverRangeSquaredIsTooLittle) {
  LidarSensorConfig config = clean();
  config.signal_fluctuation = 0;
  // On a floor the cosine of incidence is h / r: seen up to r^3 = grey h white_range^2, here 10 m,
  // between the ring at 9.6 m and the one at 28.6 m.
  config.white_range_m = std::sqrt(1000 / (kGrey * 0.5));
  const LidarScan scan = turn(render({floorPart()}), config);
  const std::set<std::uint16_t> seen(scan.rings.begin(), scan.rings.end());
  EXPECT_EQ(seen, (std::set<std::uint16_t>{9, 10, 11, 12, 13, 14, 15}));
  for (std::size_t i = 0; i < scan.points.size(); ++i) {
    ASSERT_NEAR(scan.intensity[i], kGrey * 0.5 / scan.points[i].norm(), 1e-4);
  }
  // Now 9 m.
  config.white_range_m = std::sqrt(729 / (kGrey * 0.5));
  EXPECT_EQ(turn(render({floorPart()}), config).points.size(), 6u * 1800u);
}

/// Which beams returned: laser and column.
std::set<std::pair<int, float>> beams(const LidarScan& scan) {
  std::set<std::pair<int, float>> result;
  for (std::size_t i = 0; i < scan.points.size(); ++i) {
    result.insert({scan.rings[i], scan.times[i]});
  }
  return result;
}

TEST(LidarSensor, MoreIsLostFartherAwayAndWithLessLight) {
  const RgbdRenderer world = render({floorPart()});
  std::set<std::pair<int, float>> before;
  for (const double white_range_m : {40.0, 80.0, 160.0, 320.0, 640.0}) {
    LidarSensorConfig config = clean("hdl64");
    config.white_range_m = white_range_m;
    const std::set<std::pair<int, float>> now = beams(turn(world, config));
    EXPECT_TRUE(std::includes(now.begin(), now.end(), before.begin(), before.end()));
    EXPECT_GT(now.size(), before.size());
    before = now;
    std::map<int, int> per_ring;
    for (const auto& [ring, time] : now) ++per_ring[ring];
    for (int ring = 10; ring < 63; ++ring) {
      EXPECT_LE(per_ring[ring], per_ring[ring + 1] + 60) << white_range_m << " m, ring " << ring;
    }
  }
}

TEST(LidarSensor, SomeReturnsAreLostForNoReason) {
  LidarSensorConfig config = clean();
  config.random_dropout = 0.1;
  const LidarScan scan = turn(render({floorPart()}), config);
  EXPECT_NEAR(static_cast<double>(scan.points.size()), 0.9 * 8 * 1800, 150);
}

/// Two metres per second ahead while turning left by 30 degrees per second, which takes no more
/// than the two poses to interpolate.
std::vector<TimedPose> moving() {
  std::vector<TimedPose> poses = kStandstill;
  poses[1].T_world_body.translation() = Eigen::Vector3d(0.2, 0.05, 0);
  poses[1].T_world_body.linear() =
      Eigen::AngleAxisd(3 * kDegree, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  return poses;
}

TEST(LidarSensor, UndoingTheMotionPutsPointsOnTheWallAndNotUndoingItDoesNot) {
  const LidarSensorConfig config = clean();
  const LidarScan scan = turn(render({wallAhead()}), config, moving());
  const Transform T_start = moving()[0].T_world_body * config.T_body_lidar();
  const Transform T_end = moving()[1].T_world_body * config.T_body_lidar();
  double undone = 0, skewed = 0;
  for (std::size_t i = 0; i < scan.points.size(); ++i) {
    const Eigen::Vector3d point = scan.points[i].cast<double>();
    const Transform T_then = interpolate(T_start, T_end, double{scan.times[i]});
    undone = std::max(undone, std::abs((T_then * point).x() - 10));
    skewed = std::max(skewed, std::abs((T_end * point).x() - 10));
  }
  EXPECT_GT(scan.points.size(), 5000u);
  EXPECT_LT(undone, 1e-4);
  EXPECT_GT(skewed, 0.1);
}

TEST(LidarSensor, WithoutEgoMotionAllIsMeasuredAtTheEnd) {
  LidarSensorConfig config = clean();
  config.ego_motion = false;
  const LidarScan scan = turn(render({wallAhead()}), config, moving());
  EXPECT_TRUE(scan.times.empty());
  EXPECT_EQ(scan.start_ns, scan.stamp_ns);
  const Transform T_end = moving()[1].T_world_body * config.T_body_lidar();
  for (const Eigen::Vector3f& point : scan.points) {
    ASSERT_NEAR((T_end * point.cast<double>()).x(), 10, 1e-4);
  }
}

TEST(LidarSensor, ClassesAreGivenOnRequestOnly) {
  LidarSensorConfig config = clean();
  const RgbdRenderer world = render({floorPart(), wallAhead()});
  EXPECT_TRUE(turn(world, config).labels.empty());
  config.labels = true;
  const LidarScan scan = turn(world, config);
  ASSERT_EQ(scan.labels.size(), scan.points.size());
  for (std::size_t i = 0; i < scan.points.size(); ++i) {
    const bool on_wall = scan.points[i].z() > -0.499f;
    ASSERT_EQ(scan.labels[i], on_wall ? office_label::kWall : office_label::kFloor);
  }
}

TEST(LidarSensor, TheSameSeedGivesTheSameBytesForAnyNumberOfThreads) {
  const RgbdRenderer world = render({floorPart(), wallAhead()});
  const LidarSensorConfig config = LidarSensorConfig::forPattern("hdl64", "hard");
  setNumThreads(1);
  const LidarScan one = turn(world, config, moving());
  for (const int threads : {2, 7}) {
    setNumThreads(threads);
    const LidarScan many = turn(world, config, moving());
    EXPECT_TRUE(many.points == one.points);
    EXPECT_TRUE(many.intensity == one.intensity);
    EXPECT_TRUE(many.rings == one.rings);
    EXPECT_TRUE(many.times == one.times);
  }
  setNumThreads(0);
  EXPECT_FALSE(turn(world, config, moving(), 2).points == one.points);
}

LidarSensorConfig configOf(const std::string& yaml, const std::string& preset = "default") {
  LidarSensorConfig config;
  ConfigReader reader(ConfigDocument::fromString(yaml));
  read(reader, preset, config);
  reader.finish();
  return config;
}

TEST(LidarSensorConfig, KeysStandOverPatternAndPreset) {
  EXPECT_FALSE(configOf("{}").enabled);
  const LidarSensorConfig config =
      configOf("{enabled: true, pattern: hdl64, range_noise_m: 0.05, labels: true}", "clean");
  EXPECT_EQ(config.pattern, "hdl64");
  EXPECT_EQ(config.range_noise_m, 0.05);
  EXPECT_EQ(config.random_dropout, 0);
  EXPECT_EQ(config.max_range_m, 120);
  EXPECT_TRUE(config.labels);
  EXPECT_EQ(configOf("mount: {yaw_deg: 12, translation_m: [1, 2, 3]}").translation_m.z(), 3);
}

TEST(LidarSensorConfig, WhatMakesNoSenseIsRefusedInOneLine) {
  const auto fault = [](const std::string& yaml) {
    try {
      configOf(yaml);
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string("accepted");
  };
  EXPECT_THAT(fault("{pattern: vlp32}"), HasSubstr("pattern"));
  EXPECT_THAT(fault("{pattern: vlp32}"), HasSubstr("vlp16, hdl64"));
  EXPECT_THAT(fault("mount: {translation_m: [1, 2]}"), HasSubstr("expected three numbers"));
  EXPECT_THAT(fault("{min_range_m: 5, max_range_m: 4}"),
              HasSubstr("must be larger than min_range_m"));
  EXPECT_THAT(fault("mount: {roll_deg: .nan}"), HasSubstr("roll_deg"));
}

}  // namespace
}  // namespace hydrabench

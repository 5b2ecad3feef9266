// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "core/lidar/lidar_input.h"

#include <cmath>
#include <limits>
#include <set>
#include <string>
#include <utility>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/types/error.h"
#include "tests/core/lidar/scans.h"

namespace hydrabench {
namespace {

const LabelSpace kLabels = {{{2, "grass", {}, false, false}, {9, "human", {}, false, false}}};

ActiveWindow::Config window() {
  ActiveWindow::Config config;
  config.tsdf.voxel_size_m = 0.2;
  config.tsdf.truncation_m = 0.4;
  return config;
}

LidarInput::Config lidar() {
  LidarInput::Config config;
  config.enabled = true;
  config.ground.type = "semantic";
  config.ground.semantic.labels = {"grass"};
  return config;
}

Frame frameWith(LidarScan scan, Label label) {
  Frame frame;
  frame.stamp_ns = scan.stamp_ns;
  scan.labels.assign(scan.points.size(), label);
  frame.scans.push_back(std::move(scan));
  return frame;
}

/// Share of the squares of 0.2 m between 3 and 9 m from the sensor that have a vertex within 0.2 m
/// of the ground.
double groundCovered(const LidarInput::Config& config, Label label = 2) {
  ActiveWindow map(window());
  LidarInput input(config, kLabels, {9});
  StageTimes times;
  input.integrate(frameWith(scanOfGround(0.5), label), map, times);
  map.finish();
  std::set<std::pair<int, int>> covered;
  for (const Eigen::Vector3d& p : map.mesh().mesh().vertices) {
    if (std::abs(p.z()) > 0.2) continue;
    covered.insert(
        {static_cast<int>(std::floor(p.x() / 0.2)), static_cast<int>(std::floor(p.y() / 0.2))});
  }
  int squares = 0;
  int hit = 0;
  for (int x = -45; x < 45; ++x) {
    for (int y = -45; y < 45; ++y) {
      const double range = 0.2 * std::hypot(x + 0.5, y + 0.5);
      if (range < 3 || range > 9) continue;
      ++squares;
      hit += covered.contains({x, y}) ? 1 : 0;
    }
  }
  return static_cast<double>(hit) / squares;
}

TEST(LidarInput, MapsGroundThatTheBandKeepsWhole) {
  LidarInput::Config config = lidar();
  const double with = groundCovered(config);
  config.integrator.ground_band.extra_m = 0;
  const double without = groundCovered(config);
  EXPECT_GT(with, without + 0.1) << "with " << with << ", without " << without;
}

TEST(LidarInput, HasNoBandWhereNothingIsGround) {
  LidarInput::Config config = lidar();
  config.ground.type = "none";
  const double none = groundCovered(config);
  config.integrator.ground_band.extra_m = 0;
  EXPECT_EQ(groundCovered(config), none);
}

TEST(LidarInput, KeepsMovingThingsOutOfTheMap) { EXPECT_EQ(groundCovered(lidar(), 9), 0); }

TEST(LidarInput, DoesNothingUnlessItIsOn) {
  LidarInput::Config config = lidar();
  config.enabled = false;
  ActiveWindow map(window());
  LidarInput input(config, kLabels, {});
  StageTimes times;
  input.integrate(frameWith(scanOfGround(0.5), 2), map, times);
  EXPECT_EQ(map.volume().numBlocks(), 0u);
  EXPECT_TRUE(input.cameraInMap());
  EXPECT_FALSE(input.replacesDepth());
  EXPECT_NO_THROW(input.requireScans());
}

TEST(LidarInput, SaysSoWhereNoScanEverCame) {
  const LidarInput input(lidar(), kLabels, {});
  try {
    input.requireScans();
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("no frame came with a lidar scan"));
  }
}

TEST(LidarInput, CountsPointsWithoutAReturn) {
  LidarScan scan = scanOfGround(0.5);
  const std::size_t count = scan.points.size();
  LidarInput input(lidar(), kLabels, {});
  ActiveWindow map(window());
  StageTimes times;
  input.integrate(frameWith(scan, 2), map, times);
  EXPECT_TRUE(input.notes().empty());
  scan.points[0].setZero();
  scan.points[1].setConstant(std::numeric_limits<float>::quiet_NaN());
  input.integrate(frameWith(scan, 2), map, times);
  EXPECT_THAT(input.notes(),
              testing::ElementsAre(testing::HasSubstr("2 of " + std::to_string(2 * count) +
                                                      " points are not finite or at the sensor")));
}

TEST(LidarInput, PassesOverSweepsWithoutAReturnUnlessThereIsNothingElse) {
  LidarScan blind = scanOfGround(0.5);
  blind.points.assign(blind.points.size(), Eigen::Vector3f::Zero());
  LidarInput input(lidar(), kLabels, {});
  ActiveWindow map(window());
  StageTimes times;
  input.integrate(frameWith(blind, 2), map, times);
  EXPECT_THAT(input.notes(), testing::Contains("lidar: 1 sweeps without any return, passed over"));
  try {
    input.requireScans();
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("none of the 1 lidar sweeps has a return"));
  }
  input.integrate(frameWith(scanOfGround(0.5), 2), map, times);
  EXPECT_NO_THROW(input.requireScans());
  EXPECT_GT(map.volume().numBlocks(), 0u);
}

TEST(LidarInput, RefusesAMeshThatWouldHaveNothingOfTheBand) {
  const auto faultOf = [](const char* yaml) -> std::string {
    ConfigReader reader(ConfigDocument::fromString(yaml, "method.yaml"));
    LidarInput::Config input = lidar();
    ActiveWindow::Config map;
    auto section = reader.section("window");
    read(section, map);
    auto lidar_section = reader.section("lidar");
    read(lidar_section, input);
    requireBandInMesh(section, map, input);
    try {
      reader.finish();
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_THAT(faultOf("window: {mesh_min_weight: 0.5}\n"),
              testing::HasSubstr("mesh_min_weight: 0.5 is above "
                                 "lidar.integrator.ground_band.weight, 0.001"));
  EXPECT_EQ(faultOf("window: {mesh_min_weight: 0.001}\n"), "");
  EXPECT_EQ(faultOf("window: {mesh_min_weight: 0.5}\n"
                    "lidar: {integrator: {ground_band: {extra_m: 0}}}\n"),
            "");
  EXPECT_EQ(faultOf("window: {mesh_min_weight: 0.5}\nlidar: {enabled: false}\n"), "");
}

TEST(LidarInput, RefusesGroundClassesTheDatasetDoesNotHave) {
  LidarInput::Config config = lidar();
  config.ground.semantic.labels = {"gras"};
  EXPECT_THROW(LidarInput(config, kLabels, {}), InputError);
}

TEST(LidarInput, FillsTheDepthThatTheCameraDidNotMeasure) {
  Frame frame = frameWith(scanOfGround(0.5), 2);
  frame.camera = {100, 80, 100, 100, 50, 40};
  frame.T_world_camera = lookAt({0, 0, 0.5}, {4, 0, 0});
  frame.depth = Image<float>(100, 80);
  frame.depth(50, 30) = 1.25f;
  ActiveWindow map(window());
  StageTimes times;
  for (const char* kind : {"filled", "lidar"}) {
    LidarInput::Config config = lidar();
    config.object_depth = kind;
    LidarInput input(config, kLabels, {});
    input.integrate(frame, map, times);
    ASSERT_TRUE(input.replacesDepth());
    const Frame with = input.withLidarDepth(frame, times);
    EXPECT_EQ(with.depth(50, 30) == 1.25f, std::string(kind) == "filled");
    // Where the axis meets the ground the z-depth is sqrt(4^2 + 0.5^2); rows are 2 degrees apart.
    EXPECT_NEAR(with.depth(50, 40), std::sqrt(16.25), 0.7);
  }
}

}  // namespace
}  // namespace hydrabench

// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/simulation/simulated_lidar.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "eval/simulation/simulated_dataset.h"
#include "tests/eval/simulation/simple_scenes.h"

namespace hydrabench {
namespace {

constexpr double kDegree = std::numbers::pi / 180;
constexpr std::int64_t kFirst_ns = 1'700'000'000'000'000'000;
constexpr std::int64_t kFrame_ns = 100'000'000;

/// Through the left of the two rooms, slowly turning, the camera 0.8 m high and pitched down.
std::vector<StampedPose> drive(std::size_t num_frames = 12) {
  std::vector<StampedPose> poses;
  for (std::size_t i = 0; i < num_frames; ++i) {
    const auto step = static_cast<double>(i);
    poses.push_back({kFirst_ns + static_cast<std::int64_t>(i) * kFrame_ns,
                     cameraPose({1, 0.8 + 0.1 * step}, 0.8, 0.2 * step, 8 * kDegree)});
  }
  return poses;
}

RgbdSensorConfig smallCamera() {
  RgbdSensorConfig sensor;
  sensor.camera = {48, 32, 28, 28, 24, 16};
  return sensor;
}

class World {
 public:
  explicit World(const LidarSensorConfig& lidar, const OdometryDriftConfig& drift = {})
      : dataset_("rooms", std::make_shared<const Scene>(twoRooms()), drive(), smallCamera(), drift,
                 5) {
    dataset_.mountLidar(lidar, cameraOnBody(0.8, 8));
  }
  std::vector<LidarScan> scans(std::size_t index) const { return dataset_.frame(index).scans; }
  const SimulatedDataset& dataset() const { return dataset_; }

 private:
  SimulatedDataset dataset_;
};

LidarSensorConfig clean() { return LidarSensorConfig::forPattern("vlp16", "clean"); }

TEST(SimulatedLidar, TurnsEndAtTheirOwnTimesAndFollowEachOtherWithoutAGap) {
  LidarSensorConfig config = clean();
  config.offset_s = 0.03;
  config.rate_hz = 25;  // 40 ms
  const World world(config);
  std::vector<LidarScan> all;
  for (std::size_t i = 0; i < 12; ++i) {
    const std::int64_t frame_ns = kFirst_ns + static_cast<std::int64_t>(i) * kFrame_ns;
    for (const LidarScan& scan : world.scans(i)) {
      EXPECT_LE(scan.stamp_ns, frame_ns);
      EXPECT_GT(scan.stamp_ns, frame_ns - kFrame_ns);
      all.push_back(scan);
    }
  }
  // Turns that begin at 30 ms, 70 ms ... and end by 1100 ms: the last one ends at 1070 ms.
  ASSERT_EQ(all.size(), 26u);
  for (std::size_t i = 0; i < all.size(); ++i) {
    EXPECT_EQ(all[i].start_ns, kFirst_ns + 30'000'000 + static_cast<std::int64_t>(i) * 40'000'000);
    EXPECT_EQ(all[i].stamp_ns, all[i].start_ns + 40'000'000);
  }
}

TEST(SimulatedLidar, ATurnThatEndsWithAFrameBelongsToIt) {
  LidarSensorConfig config = clean();
  config.offset_s = 0;
  const World world(config);
  EXPECT_TRUE(world.scans(0).empty()) << "it would have begun before the drive";
  for (std::size_t i = 1; i < 12; ++i) {
    ASSERT_EQ(world.scans(i).size(), 1u);
    EXPECT_EQ(world.scans(i)[0].stamp_ns, kFirst_ns + static_cast<std::int64_t>(i) * kFrame_ns);
  }
}

TEST(SimulatedLidar, StandsUprightOnTheGroundUnderThePitchedCamera) {
  LidarSensorConfig config = clean();
  config.offset_s = 0.025;
  const LidarScan scan = World(config).scans(3).at(0);
  // A quarter of the way from frame 2 to frame 3.
  const Eigen::Vector3d place(1, 0.8 + 0.1 * 2.25, 0.5);
  EXPECT_LT((scan.T_world_lidar.translation() - place).norm(), 1e-9);
  EXPECT_TRUE(scan.T_world_lidar.linear().isApprox(
      Eigen::AngleAxisd(0.2 * 2.25, Eigen::Vector3d::UnitZ()).toRotationMatrix(), 1e-9));
}

TEST(SimulatedLidar, PosesBetweenFramesPutThePointsOntoTheRoom) {
  const LidarScan scan = World(clean()).scans(5).at(0);
  int on_wall = 0;
  for (std::size_t i = 0; i < scan.points.size(); ++i) {
    const Eigen::Vector3d point =
        interpolate(scan.T_world_lidar_start, scan.T_world_lidar, double{scan.times[i]}) *
        scan.points[i].cast<double>();
    EXPECT_GT(point.z(), -0.002);
    // Where nothing else stands.
    const bool at_wall = point.y() < 0.3 && point.z() > 0.05 && point.z() < 2.4 &&
                         point.x() > 0.3 && point.x() < 3.7;
    if (!at_wall) continue;
    EXPECT_NEAR(point.y(), 0, 0.002);  // the turn spans two steps of the drive
    ++on_wall;
  }
  EXPECT_GT(on_wall, 500);
}

TEST(SimulatedLidar, ReportedPosesDriftWithOdometryAndPointsDoNot) {
  const OdometryDriftConfig drift{.translation_m_per_sqrt_m = 0.2, .yaw_deg_per_sqrt_m = 10};
  const World exact(clean());
  const World drifting(clean(), drift);
  const LidarScan a = exact.scans(11).at(0);
  const LidarScan b = drifting.scans(11).at(0);
  EXPECT_TRUE(a.points == b.points);
  EXPECT_GT((a.T_world_lidar.translation() - b.T_world_lidar.translation()).norm(), 0.01);
  // Between the two frames around it, as far as the camera's reported poses are.
  const Transform T_camera_body = cameraOnBody(0.8, 8).inverse();
  const Transform before = drifting.dataset().frame(10).T_world_camera * T_camera_body;
  const Transform after = drifting.dataset().frame(11).T_world_camera * T_camera_body;
  EXPECT_TRUE(
      b.T_world_lidar.isApprox(interpolate(before, after, 0.3) * clean().T_body_lidar(), 1e-9));
}

TEST(SimulatedLidar, ImagesAreTheSameWithAndWithoutIt) {
  const SimulatedDataset without("rooms", std::make_shared<const Scene>(twoRooms()), drive(),
                                 smallCamera(), {}, 5);
  const World with(LidarSensorConfig::forPattern("hdl64", "default"));
  const Frame a = without.frame(6);
  const Frame b = with.dataset().frame(6);
  EXPECT_TRUE(a.scans.empty());
  EXPECT_EQ(b.scans.size(), 1u);
  EXPECT_TRUE(a.color == b.color);
  EXPECT_TRUE(a.depth == b.depth);
  EXPECT_TRUE(a.labels == b.labels);
  EXPECT_TRUE(a.instances == b.instances);
  EXPECT_EQ(a.T_world_camera.matrix(), b.T_world_camera.matrix());
}

TEST(SimulatedLidar, FramesMayBeAskedForInAnyOrder) {
  const World world(LidarSensorConfig::forPattern("vlp16", "hard"));
  const LidarScan late = world.scans(9).at(0);
  const LidarScan early = world.scans(4).at(0);
  EXPECT_TRUE(world.scans(9).at(0).points == late.points);
  EXPECT_TRUE(world.scans(4).at(0).points == early.points);
}

}  // namespace
}  // namespace hydrabench

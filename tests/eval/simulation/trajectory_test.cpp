// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/simulation/trajectory.h"

#include <algorithm>
#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/types/error.h"
#include "eval/simulation/clearance_map.h"
#include "eval/simulation/rgbd_renderer.h"
#include "eval/simulation/visibility.h"
#include "tests/eval/simulation/simple_scenes.h"

namespace hydrabench {
namespace {

constexpr double kPi = 3.14159265358979;
const Camera kCamera = {720, 480, 415.7, 415.7, 360, 240};

TrajectoryConfig shortDrive() {
  TrajectoryConfig config;
  config.duration_s = 25;
  return config;
}

/// The right room can only be crossed in a zigzag around two screens.
Scene roomsWithScreens() {
  Scene scene = twoRooms();
  scene.structure.push_back(
      structureBox("screen", office_label::kWall,
                   {Eigen::Vector3d(5.2, 0, 0), Eigen::Vector3d(5.25, 3.2, 1.6)}));
  scene.structure.push_back(
      structureBox("screen", office_label::kWall,
                   {Eigen::Vector3d(6.3, 0.8, 0), Eigen::Vector3d(6.35, 4, 1.6)}));
  return scene;
}

struct Drive {
  explicit Drive(const TrajectoryConfig& settings = shortDrive(), Scene world = twoRooms())
      : config(settings),
        scene(std::make_shared<const Scene>(std::move(world))),
        renderer(scene),
        poses(makeTrajectory(*scene, renderer.raycaster(), kCamera, config)) {}
  TrajectoryConfig config;
  std::shared_ptr<const Scene> scene;
  RgbdRenderer renderer;
  std::vector<StampedPose> poses;
};

TEST(Trajectory, HasAPosePerFrameAtTheRateAskedFor) {
  const Drive drive;
  ASSERT_EQ(drive.poses.size(), 250u);
  for (std::size_t i = 0; i < drive.poses.size(); ++i) {
    EXPECT_EQ(drive.poses[i].stamp_ns, static_cast<std::int64_t>(i) * 100'000'000);
    EXPECT_DOUBLE_EQ(drive.poses[i].T_world_camera.translation().z(), drive.config.camera_height_m);
  }
}

TEST(Trajectory, KeepsTheRobotsRadiusFromEverything) {
  TrajectoryConfig config;
  config.duration_s = 50;
  config.robot_radius_m = 0.34;  // ways past the screens are 0.8 m wide
  const Drive drive(config, roomsWithScreens());
  EXPECT_TRUE(std::any_of(drive.poses.begin(), drive.poses.end(), [](const StampedPose& pose) {
    return pose.T_world_camera.translation().x() > 6.4;
  }));
  for (const StampedPose& pose : drive.poses) {
    for (const double z : {0.1, 0.4, 0.8}) {
      const Eigen::Vector3d& eye = pose.T_world_camera.translation();
      const auto nearest = drive.renderer.raycaster().nearest({eye.x(), eye.y(), z});
      // The floor is nearer than the radius at the lowest height. The grid knows obstacles to about
      // a cell's half diagonal.
      if (nearest.position.z() < 0.05) continue;
      EXPECT_GT(nearest.distance, drive.config.robot_radius_m - 0.04);
    }
  }
}

TEST(Trajectory, NeverMovesOrTurnsFasterThanAllowed) {
  const Drive drive;
  for (std::size_t i = 1; i < drive.poses.size(); ++i) {
    const Transform& before = drive.poses[i - 1].T_world_camera;
    const Transform& after = drive.poses[i].T_world_camera;
    const double speed = (after.translation() - before.translation()).norm() * drive.config.rate_hz;
    const double turn =
        rotationAngle(after.linear(), before.linear()) * drive.config.rate_hz * 180 / kPi;
    EXPECT_LE(speed, drive.config.max_speed_m_s + 1e-6);
    EXPECT_LE(turn, drive.config.max_yaw_rate_deg_s + 1e-6);
  }
}

TEST(Trajectory, VisitsEveryRoomAndSeesEveryObject) {
  const Drive drive;
  for (const Room& room : drive.scene->rooms) {
    EXPECT_TRUE(std::any_of(drive.poses.begin(), drive.poses.end(), [&](const StampedPose& pose) {
      return room.box.contains(pose.T_world_camera.translation());
    })) << room.name;
  }
  const std::vector<double> visible = visibleFractions(*drive.scene, drive.renderer.raycaster(),
                                                       kCamera, drive.poses, 0.1, 5, 2, 200);
  // Of the couch the top is level with the camera and the back faces the wall: 40 % is the most
  // there is to see.
  EXPECT_THAT(visible, testing::Each(testing::Gt(0.25)));
}

TEST(Trajectory, LooksLevelAndSlightlyDown) {
  const Drive drive;
  for (const StampedPose& pose : drive.poses) {
    const Eigen::Matrix3d& R = pose.T_world_camera.linear();
    EXPECT_NEAR(R(2, 0), 0, 1e-9);  // camera x is horizontal
    EXPECT_NEAR(R(2, 2), -std::sin(drive.config.camera_pitch_deg * kPi / 180), 1e-9);
  }
}

TEST(Trajectory, SaysWhenTheTimeIsTooShort) {
  TrajectoryConfig config = shortDrive();
  config.duration_s = 3;
  try {
    const Drive drive(config);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("trajectory.duration_s: 3 s are too short"));
  }
}

TEST(Trajectory, SaysWhichRoomTheRobotDoesNotFitInto) {
  TrajectoryConfig config = shortDrive();
  config.robot_radius_m = 0.6;  // the door is 1 m wide
  try {
    const Drive drive(config);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("does not get into room right"));
  }
}

TEST(ClearanceMap, KnowsTheDistanceToTheNearestWallOrObject) {
  const ClearanceMap map(twoRooms(), 0.05, 1.0);
  EXPECT_NEAR(map.at({0.5, 2}), 0.5, 0.04);   // west wall
  EXPECT_NEAR(map.at({2, 0.8}), 0.8, 0.04);   // south wall
  EXPECT_NEAR(map.at({2.9, 2}), 0.65, 0.04);  // the box in the middle reaches to x = 2.25
  EXPECT_NEAR(map.at({4.1, 2}), 0.5, 0.04);   // in the doorway
  EXPECT_EQ(map.at({20, 20}), 0);
}

TEST(ClearanceMap, IgnoresWhatIsAboveAndBelowTheRobot) {
  Scene scene = twoRooms();
  scene.objects.clear();
  scene.objects.push_back(boxObject("lamp", office_label::kLamp, {0.5, 0.5, 0.5}, {2, 2, 1.5}));
  EXPECT_NEAR(ClearanceMap(scene, 0.05, 1.0).at({2, 2}), 2.0, 0.04);
}

TEST(RouteMap, GoesThroughTheDoor) {
  const ClearanceMap map(twoRooms(), 0.05, 1.0);
  const RouteMap routes(map, map.cellAt({1, 3.5}), 0.25);
  const std::size_t goal = map.cellAt({5, 3.5});
  ASSERT_TRUE(routes.reaches(goal));
  for (const std::size_t cell : routes.route(goal)) {
    const Eigen::Vector2d p = map.center(cell);
    if (std::abs(p.x() - 4.1) < 0.1) {
      EXPECT_NEAR(p.y(), 2, 0.3);
    }
    EXPECT_GE(map.atCell(cell), 0.25);
  }
  EXPECT_FALSE(RouteMap(map, map.cellAt({1, 3.5}), 0.55).reaches(goal));
}

}  // namespace
}  // namespace hydrabench

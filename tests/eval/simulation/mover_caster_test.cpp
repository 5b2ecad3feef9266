// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/simulation/mover_caster.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "eval/simulation/lidar_sensor.h"
#include "eval/simulation/rgbd_sensor.h"
#include "eval/simulation/trajectory.h"
#include "tests/eval/simulation/simple_scenes.h"

namespace hydrabench {
namespace {

constexpr Label kMoving = 77;
constexpr std::int64_t kSecond_ns = 1'000'000'000;
const Camera kCamera = {101, 67, 60, 60, 50, 33};
const Transform kFacingWall = cameraPose({0, 0}, 0, 1.5707963267948966, 0);

Transform at(const Eigen::Vector3d& place) { return Transform(Eigen::Translation3d(place)); }

/// A box whose centre goes straight from one place to another, turning as it does, in the second
/// that begins at 0.
Mover movingBox(const Eigen::Vector3d& dimensions, const Transform& from, const Transform& to) {
  auto surface = std::make_shared<Surface>();
  surface->materials = {{{255, 255, 255}, {255, 255, 255}, Material::Pattern::kPlain, 1, 0}};
  appendBox({-0.5 * dimensions, Eigen::Vector3d(0.5 * dimensions)}, 0, *surface);
  return {"box", kMoving, {{surface, {{0, from}, {kSecond_ns, to}}}}};
}

StructurePart wall(const Eigen::Vector3d& low, const Eigen::Vector3d& high) {
  return structureBox("wall", office_label::kWall, Aabb(low, high));
}

/// The face y = 2 of a wall; before it a box of 0.41 m that crosses from left to right with its
/// face at y = 1, and a thin post at rest whose face is y = 0.5.
std::shared_ptr<const Scene> crossing() {
  Scene scene;
  scene.structure.push_back(wall({-10, 2, -10}, {10, 2.2, 10}));
  scene.objects.push_back(boxObject("post", office_label::kBin, {0.02, 0.02, 2}, {0, 0.51, -1}));
  scene.movers.push_back(movingBox({0.41, 0.41, 0.41}, at({-1, 1.205, 0}), at({1, 1.205, 0})));
  scene.sun = Sun{};
  return std::make_shared<const Scene>(std::move(scene));
}

TEST(Movers, ABoxBeforeAWallIsSeenWhereItIsAtTheTimeOfThePicture) {
  const RgbdRenderer renderer(crossing());
  for (const double t : {0.0, 0.2, 0.71, 1.0}) {
    const RenderedView view =
        renderer.render(kCamera, kFacingWall, static_cast<std::int64_t>(t * kSecond_ns));
    const double low = -1 + 2 * t - 0.205;
    const double high = low + 0.41;
    for (int u = 0; u < kCamera.width; ++u) {
      const double x = (u - 50) / 60.0;  // of the ray, to each metre of depth
      if (std::abs(x) < 0.03) continue;  // behind the post
      // Between these depths the ray is between the sides of the box.
      const double enter = std::min(low / x, high / x);
      const double leave = std::max(low / x, high / x);
      const bool on_front = enter < 1 && leave > 1;
      const bool on_side = enter >= 1 && enter < 1.41;
      const bool on_box = on_front || on_side;
      ASSERT_NEAR(view.depth(u, 33), on_front ? 1 : on_side ? enter : 2, 1e-5) << t << " " << u;
      EXPECT_EQ(view.labels(u, 33), on_box ? kMoving : office_label::kWall);
      EXPECT_EQ(view.objects(u, 33), on_box ? 1 : -1);  // behind the one object of the scene
      const double facing = (on_side ? std::abs(x) : 1) / std::sqrt(1 + x * x);
      EXPECT_NEAR(view.incidence(u, 33), 255 * facing, 1);
    }
  }
}

TEST(Movers, WhatStandsBeforeThemHidesThem) {
  const RenderedView view = RgbdRenderer(crossing()).render(kCamera, kFacingWall, kSecond_ns / 2);
  EXPECT_NEAR(view.depth(50, 33), 0.5, 1e-5);
  EXPECT_EQ(view.labels(50, 33), office_label::kBin);
  EXPECT_EQ(view.labels(54, 33), kMoving);
}

TEST(Movers, AreNotThereBeforeAndAfterTheirPoses) {
  const RgbdRenderer renderer(crossing());
  for (const std::int64_t stamp_ns : {-1L, kSecond_ns + 1}) {
    const RenderedView view = renderer.render(kCamera, kFacingWall, stamp_ns);
    EXPECT_EQ(std::count(view.labels.begin(), view.labels.end(), kMoving), 0);
  }
}

TEST(Movers, ATurningBoxIsSeenFromItsCorner) {
  // A quarter of a turn in a second: after half of it the corner points at the camera, at a depth
  // of 2 - sqrt(1/2).
  Scene scene;
  const Transform ahead = at({0, 2, 0});
  scene.movers.push_back(
      movingBox({1, 1, 1}, ahead,
                ahead * Eigen::AngleAxisd(0.5 * 3.14159265358979, Eigen::Vector3d::UnitZ())));
  const RgbdRenderer renderer(std::make_shared<const Scene>(std::move(scene)));
  EXPECT_NEAR(renderer.render(kCamera, kFacingWall, 0).depth(50, 33), 1.5, 1e-5);
  const RenderedView corner = renderer.render(kCamera, kFacingWall, kSecond_ns / 2);
  EXPECT_NEAR(corner.depth(50, 33), 2 - std::sqrt(0.5), 1e-4);
  EXPECT_NEAR(corner.incidence(51, 33), 255 * std::sqrt(0.5), 4);
}

TEST(Movers, CastShadowsWhereTheyAre) {
  // The sun stands behind the camera, high: the shadow on the wall is lower than the box.
  Scene scene = *crossing();
  scene.objects.clear();
  scene.sun->to_sun = Eigen::Vector3d(0, -1, 1).normalized();
  const RgbdRenderer renderer(std::make_shared<const Scene>(std::move(scene)));
  // The box's centre at x = 0.4 shades the wall about (0.4, 2, -0.795): column 62, row 57.
  const auto brightness = [&](std::int64_t stamp_ns) {
    return int{renderer.render(kCamera, kFacingWall, stamp_ns).color(62, 57).g};
  };
  EXPECT_LT(brightness(7 * kSecond_ns / 10) + 40, brightness(0));
}

TEST(Movers, HaveAnInstanceOfTheirOwnInAFrame) {
  const auto scene = crossing();
  const Frame frame = observe(
      *scene, RgbdRenderer(scene), kFacingWall,
      [] {
        RgbdSensorConfig config = RgbdSensorConfig::clean();
        config.camera = kCamera;
        return config;
      }(),
      1, 0, kSecond_ns / 2);
  EXPECT_EQ(frame.stamp_ns, kSecond_ns / 2);
  const InstanceId mover = frame.instances(54, 33);
  ASSERT_NE(mover, kNoInstance);
  EXPECT_NE(mover, frame.instances(50, 33));
  EXPECT_EQ(frame.instance_labels.at(mover), kMoving);
  EXPECT_EQ(frame.labels(54, 33), kMoving);
}

TEST(Movers, ALidarMeetsThemWhereTheyAreAtTheTimeOfEachColumn) {
  // A plate comes towards the sensor at 12 m/s; its face is at x = 8 - 12 t. Before a wall at 10 m.
  Scene scene;
  scene.structure.push_back(wall({10, -50, -20}, {11, 50, 30}));
  scene.movers.push_back(movingBox({0.2, 8, 8}, at({8.1, 0, 0.5}), at({-3.9, 0, 0.5})));
  const RgbdRenderer world(std::make_shared<const Scene>(std::move(scene)));
  const std::int64_t turn_ns = kSecond_ns / 10;
  const std::vector<TimedPose> standstill = {{0, Transform::Identity()},
                                             {kSecond_ns, Transform::Identity()}};
  LidarSensorConfig config = LidarSensorConfig::forPattern("vlp16", "clean");
  config.labels = true;
  for (const bool ego_motion : {true, false}) {
    const std::int64_t end_ns = 3 * turn_ns;
    const LidarScan scan =
        sweep(world, standstill, ego_motion ? end_ns - turn_ns : end_ns, end_ns, config, 1);
    std::size_t on_plate = 0;
    double nearest = 100;
    double farthest = 0;
    for (std::size_t i = 0; i < scan.points.size(); ++i) {
      const double t = ego_motion ? 0.2 + 0.1 * double{scan.times[i]} : 0.3;
      const bool plate = scan.labels[i] == kMoving;
      const double x = double{scan.points[i].x()};
      ASSERT_NEAR(x, plate ? 8 - 12 * t : 10, 1e-4);
      on_plate += plate;
      if (!plate) continue;
      nearest = std::min(nearest, x);
      farthest = std::max(farthest, x);
    }
    EXPECT_GT(on_plate, 3000u);
    // The plate is swept in the 70 to 80 degrees around straight ahead.
    if (ego_motion) {
      EXPECT_GT(farthest - nearest, 0.2);
    } else {
      EXPECT_LT(farthest - nearest, 1e-4);
    }
  }
}

}  // namespace
}  // namespace hydrabench

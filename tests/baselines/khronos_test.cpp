// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "baselines/khronos/khronos.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/parallel/parallel_for.h"
#include "tests/support/miniature_world.h"

namespace hydrabench {
namespace {

using Eigen::Vector3d;
using Path = MiniatureWorld::Path;
namespace label = miniature_label;

Path then(Path first, const Path& second) {
  first.insert(first.end(), second.begin(), second.end());
  return first;
}
std::int64_t after(const Path& path) { return path.back().stamp_ns + kMiniaturePeriodNs; }

SceneGraph drive(MiniatureWorld& world, const Path& path, const Khronos::Config& config = {}) {
  Khronos khronos(config, miniatureLabelSpace());
  return world.drive(path, khronos);
}

/// A room with one thing of class chair in it.
MiniatureWorld roomWith(const Mesh& thing) {
  MiniatureWorld world;
  world.addRoom(7, 7, 2.5);
  world.add(thing, label::kChair, 1);
  return world;
}
MiniatureWorld roomWithBox() { return roomWith(standingBox(0.5, 0.5, 0.8)); }

Path fromAbove(int num_views, std::int64_t start_ns = kMiniatureStartNs) {
  return stillPath({1.6, 0.2, 1.5}, {0, 0, 0.4}, num_views, start_ns);
}
Path fromBehind(int num_views, std::int64_t start_ns) {
  return stillPath({-1.6, -0.2, 1.5}, {0, 0, 0.4}, num_views, start_ns);
}
Path lookingAway(int num_views, std::int64_t start_ns) {
  return stillPath({1.6, 0.2, 1.5}, {3.4, 0, 1.5}, num_views, start_ns);
}

TEST(Khronos, AThingSeenFromOneSideGivesTheBoxOfTheSeenPart) {
  // From 2 m a ball of 0.3 m shows its cap from x = 0.3^2 / 2 = 0.045 m on; its centre is at 0.
  MiniatureWorld world = roomWith(sphereMesh({0, 0, 1}, 0.3, 4));
  const SceneGraph graph = drive(world, stillPath({2, 0, 1}, {0, 0, 1}, 20));
  ASSERT_EQ(graph.objects.size(), 1u);
  const ObjectNode& ball = graph.objects[0];
  EXPECT_EQ(ball.label, label::kChair);
  EXPECT_EQ(ball.name, "chair");
  EXPECT_NEAR(ball.box.max().x(), 0.3, 0.02);
  EXPECT_GT(ball.box.min().x(), 0.0);
  EXPECT_LT(ball.box.min().x(), 0.12);
  EXPECT_NEAR(ball.box.sizes().y(), 0.6, 0.05);
  EXPECT_NEAR(ball.box.sizes().z(), 0.6, 0.05);
  EXPECT_EQ(ball.box.min(), bounds(ball.mesh).min());
  EXPECT_EQ(ball.T_world_object.translation(), ball.box.center());
  EXPECT_EQ(ball.first_observed_ns, kMiniatureStartNs);
  EXPECT_EQ(ball.last_observed_ns, kMiniatureStartNs + 19 * kMiniaturePeriodNs);
}

TEST(Khronos, AChairSeenFromTheFrontLacksItsRear) {
  // Seen: the front of the back at x = -0.19 and between the front legs that of the rear legs at
  // x = -0.2. Not seen: their rear at x = -0.25. So the box ends 5 cm short and its middle is 2.5
  // cm off. A voxel is 0.02 * 0.9 = 0.018 m, the legs are two pixels wide.
  MiniatureWorld world = roomWith(tinyChair());
  const SceneGraph graph = drive(world, stillPath({1.6, 0, 0.8}, {0, 0, 0.45}, 20));
  ASSERT_EQ(graph.objects.size(), 1u);
  const Aabb& box = graph.objects[0].box;
  EXPECT_NEAR(box.min().x(), -0.2, 0.03);
  EXPECT_NEAR(box.max().x(), 0.25, 0.02);
  EXPECT_NEAR(box.min().y(), -0.25, 0.03);
  EXPECT_NEAR(box.max().y(), 0.25, 0.03);
  EXPECT_NEAR(box.max().z(), 0.9, 0.03);
}

TEST(Khronos, ConnectedSemanticsJoinChairsCloserThanTheGridInstancesKeepTwo) {
  // 6 cm apart: whatever cells of 10 cm the facing sides fall into, they touch.
  MiniatureWorld world;
  world.addRoom(7, 7, 2.5);
  world.add(transformed(pose(0, -0.28, 0, 0), standingBox(0.5, 0.5, 0.8)), label::kChair, 1);
  world.add(transformed(pose(0, 0.28, 0, 0), standingBox(0.5, 0.5, 0.8)), label::kChair, 2);
  const Path path = stillPath({1.8, 0, 1.2}, {0, 0, 0.4}, 20);
  const SceneGraph connected = drive(world, path);
  ASSERT_EQ(connected.objects.size(), 1u);
  EXPECT_NEAR(connected.objects[0].box.sizes().y(), 1.06, 0.06);

  Khronos::Config config;
  config.candidates.source = "instances";
  const SceneGraph instances = drive(world, path, config);
  ASSERT_EQ(instances.objects.size(), 2u);
  for (const ObjectNode& object : instances.objects) {
    EXPECT_NEAR(object.box.sizes().y(), 0.5, 0.06);
    EXPECT_NEAR(std::abs(object.box.center().y()), 0.28, 0.03);
  }
}

TEST(Khronos, AnObjectThatCrossesTheBorderOfTheWindowIsWhole) {
  // A bench of 6 m, passed at 0.8 m/s with its first metre last seen more than 3 s before the end:
  // its blocks have left the map, while the track goes on and keeps the frames.
  MiniatureWorld world;
  world.addRoom(9, 5, 2.5);
  world.add(standingBox(6, 0.5, 0.5), label::kCouch, 1);
  Path path;
  for (int i = 0; i < 75; ++i) {
    const double x = -3 + 0.08 * i;
    path = then(path, stillPath({x, -1.6, 1.2}, {x, 0, 0.3}, 1,
                                kMiniatureStartNs + i * kMiniaturePeriodNs));
  }
  Khronos khronos({}, miniatureLabelSpace());
  for (const MiniatureWorld::View& view : path) {
    khronos.process(world.frame(view.T_world_camera, view.stamp_ns));
  }
  const TsdfVolume& volume = khronos.window().volume();
  EXPECT_EQ(volume.voxel(volume.grid().voxelAt({-2.5, -0.25, 0.3})), nullptr);
  EXPECT_NE(volume.voxel(volume.grid().voxelAt({2.5, -0.25, 0.3})), nullptr);
  const SceneGraph graph = khronos.finish();
  ASSERT_EQ(graph.objects.size(), 1u);
  EXPECT_EQ(graph.objects[0].first_observed_ns, path.front().stamp_ns);
  EXPECT_EQ(graph.objects[0].last_observed_ns, path.back().stamp_ns);
  EXPECT_NEAR(graph.objects[0].box.min().x(), -3, 0.15);  // voxels of 0.02 * 6 = 0.12 m
  EXPECT_NEAR(graph.objects[0].box.max().x(), 3, 0.15);
  // And in the mesh of the scene its front face is there from end to end.
  std::vector<bool> decimetres(58, false);
  for (const Vector3d& p : graph.scene_mesh.vertices) {
    const double at = (p.x() + 2.9) / 0.1;
    if (std::abs(p.y() + 0.25) < 0.1 && p.z() > 0.1 && p.z() < 0.6 && at >= 0 && at < 58) {
      decimetres[static_cast<std::size_t>(at)] = true;
    }
  }
  EXPECT_EQ(std::count(decimetres.begin(), decimetres.end(), false), 0);
}

TEST(Khronos, AThingSeenFromAllSidesGivesItsWholeBox) {
  MiniatureWorld world = roomWithBox();
  const SceneGraph graph = drive(world, orbitPath({0, 0, 0.4}, 1.6, 1.4, 60));
  ASSERT_EQ(graph.objects.size(), 1u);
  EXPECT_LT((graph.objects[0].box.min() - Vector3d(-0.25, -0.25, 0)).cwiseAbs().maxCoeff(), 0.04);
  EXPECT_LT((graph.objects[0].box.max() - Vector3d(0.25, 0.25, 0.8)).cwiseAbs().maxCoeff(), 0.04);
}

TEST(Khronos, TheSceneMeshHasTheRoomWithLabels) {
  MiniatureWorld world = roomWithBox();
  const SceneGraph graph = drive(world, orbitPath({0, 0, 0.4}, 1.6, 1.4, 60));
  ASSERT_GT(graph.scene_mesh.faces.size(), 100u);
  ASSERT_EQ(graph.scene_labels.size(), graph.scene_mesh.vertices.size());
  for (std::size_t i = 0; i < graph.scene_labels.size(); ++i) {
    const Vector3d& p = graph.scene_mesh.vertices[i];
    if (p.head<2>().norm() > 0.6 && p.z() < 0.05 && p.cwiseAbs().maxCoeff() < 3) {
      ASSERT_EQ(graph.scene_labels[i], label::kFloor) << p.transpose();
    }
  }
}

TEST(Khronos, SixteenObservationsMakeAnObjectFifteenDoNot) {
  MiniatureWorld world = roomWithBox();
  EXPECT_EQ(drive(world, fromAbove(15)).objects.size(), 0u);
  EXPECT_EQ(drive(world, fromAbove(16)).objects.size(), 1u);
}

TEST(Khronos, ATrackEndsAfterTheWindowAndTheThingSeenAgainIsMerged) {
  MiniatureWorld world = roomWithBox();
  Path path = fromAbove(20);
  path = then(path, lookingAway(45, after(path)));
  const SceneGraph once = drive(world, path);
  ASSERT_EQ(once.objects.size(), 1u);
  path = then(path, fromBehind(20, after(path)));
  const SceneGraph twice = drive(world, path);
  ASSERT_EQ(twice.objects.size(), 1u);
  EXPECT_EQ(twice.objects[0].id, once.objects[0].id);
  EXPECT_EQ(twice.objects[0].first_observed_ns, path.front().stamp_ns);
  EXPECT_EQ(twice.objects[0].last_observed_ns, path.back().stamp_ns);
  EXPECT_GT(twice.objects[0].mesh.faces.size(), once.objects[0].mesh.faces.size());

  Khronos::Config apart;
  apart.min_merge_iou = 1;
  EXPECT_EQ(drive(world, path, apart).objects.size(), 2u);
}

TEST(Khronos, OppositeSidesThatDoNotTouchStayTwo) {
  MiniatureWorld world = roomWith(sphereMesh({0, 0, 1}, 0.3, 4));
  Path path = stillPath({2, 0, 1}, {0, 0, 1}, 20);
  path = then(path, stillPath({2, 0, 1}, {3.4, 0, 1}, 45, after(path)));
  path = then(path, stillPath({-2, 0, 1}, {0, 0, 1}, 20, after(path)));
  EXPECT_EQ(drive(world, path).objects.size(), 2u);
}

TEST(Khronos, AnInstanceIdThatFlickersDoesNotBreakTheTrack) {
  MiniatureWorld world = roomWithBox();
  world.add(transformed(pose(0, 1.2, 0, 0), standingBox(0.4, 0.4, 0.6)), label::kBin, 2);
  world.shuffleInstanceIds();
  Khronos::Config config;
  config.candidates.source = "instances";
  const SceneGraph graph = drive(world, fromAbove(20), config);
  ASSERT_EQ(graph.objects.size(), 2u);
  for (const ObjectNode& object : graph.objects) {
    EXPECT_EQ(object.last_observed_ns - object.first_observed_ns, 19 * kMiniaturePeriodNs);
  }
}

TEST(Khronos, AClassConfusedFrameDoesNotBecomeAnObject) {
  MiniatureWorld world = roomWithBox();
  world.confuse(1, label::kCouch, kMiniatureStartNs + 7 * kMiniaturePeriodNs);
  const SceneGraph graph = drive(world, fromAbove(20));
  ASSERT_EQ(graph.objects.size(), 1u);
  EXPECT_EQ(graph.objects[0].label, label::kChair);
  EXPECT_EQ(graph.objects[0].first_observed_ns, kMiniatureStartNs);
}

/// Comes out of nowhere after 3 s and then goes by in front of the camera, 0.5 m a second.
Transform passingBy(std::int64_t stamp_ns) {
  const double seconds = static_cast<double>(stamp_ns - kMiniatureStartNs) * 1e-9 - 3;
  return seconds < 0 ? pose(100, 0, 0, 0) : pose(0, -1 + 0.5 * seconds, 0.6, 0);
}

TEST(Khronos, AMovingThingEntersNeitherTheMapNorTheObjects) {
  for (const bool detect : {true, false}) {
    MiniatureWorld world;
    world.addRoom(4.5, 4.5, 2.5);  // the wall behind is in range: space in front of it is free
    world.add(standingBox(0.4, 0.4, 0.5), label::kChair, 1, passingBy);
    Khronos::Config config;
    config.motion.enabled = detect;
    config.motion.min_pixels = 100;
    Khronos khronos(config, miniatureLabelSpace());
    for (const MiniatureWorld::View& view : stillPath({2, 0, 1.2}, {0, 0, 0.8}, 70)) {
      khronos.process(world.frame(view.T_world_camera, view.stamp_ns));
    }
    // Where it went; its front is at x = 0.2. Full: not free through and through.
    std::size_t full = 0;
    for (double y = -0.8; y < 0.8; y += 0.1) {
      const VoxelGrid& grid = khronos.window().volume().grid();
      const TsdfVoxel* voxel = khronos.window().volume().voxel(grid.voxelAt({0.15, y, 0.85}));
      ASSERT_TRUE(voxel && voxel->weight > 0) << y;
      full += voxel->distance < 0.199f;
    }
    const SceneGraph graph = khronos.finish();
    if (detect) {
      EXPECT_EQ(full, 0u);
      EXPECT_EQ(graph.objects.size(), 0u);
      EXPECT_EQ(khronos.numMovingTracks(), 1u);
    } else {
      EXPECT_GT(full, 10u);  // what the test would see
    }
  }
}

TEST(Khronos, ClassesThatMoveStayOutOfTheMapEvenAtRest) {
  for (const bool known : {true, false}) {
    MiniatureWorld world;
    world.addRoom(7, 7, 2.5);
    world.add(standingBox(0.5, 0.5, 1.2), label::kHuman, 1);
    Khronos::Config config;
    if (!known) config.dynamic_classes.clear();
    const SceneGraph graph = drive(world, fromAbove(10), config);
    std::size_t on_it = 0;
    for (const Vector3d& p : graph.scene_mesh.vertices) {
      on_it += p.head<2>().cwiseAbs().maxCoeff() < 0.3 && p.z() > 0.3;
    }
    EXPECT_EQ(on_it == 0, known);
    EXPECT_TRUE(graph.objects.empty());
  }
}

TEST(Khronos, IsTheSameForAnyNumberOfThreads) {
  const auto run = [](int num_threads) {
    setNumThreads(num_threads);
    MiniatureWorld world = roomWithBox();
    world.add(transformed(pose(0.5, 1.2, 0, 0.3), tinyChair()), label::kChair, 2);
    return drive(world, orbitPath({0, 0.4, 0.4}, 1.8, 1.4, 30));
  };
  const SceneGraph one = run(1);
  const SceneGraph three = run(3);
  setNumThreads(0);
  ASSERT_GT(one.objects.size(), 0u);
  ASSERT_EQ(one.objects.size(), three.objects.size());
  for (std::size_t i = 0; i < one.objects.size(); ++i) {
    EXPECT_EQ(one.objects[i].mesh.vertices, three.objects[i].mesh.vertices);
    EXPECT_EQ(one.objects[i].mesh.faces, three.objects[i].mesh.faces);
    EXPECT_EQ(one.objects[i].mesh.colors, three.objects[i].mesh.colors);
  }
  EXPECT_EQ(one.scene_mesh.vertices, three.scene_mesh.vertices);
  EXPECT_EQ(one.scene_mesh.faces, three.scene_mesh.faces);
  EXPECT_EQ(one.scene_labels, three.scene_labels);
}

TEST(Khronos, EveryPublishedConfigIsRead) {
  for (const char* name : {"khronos", "khronos_10hz", "khronos_jackal", "khronos_instances"}) {
    ConfigReader reader(ConfigDocument::fromFile(std::string(HYDRABENCH_SOURCE_DIR) +
                                                 "/configs/methods/" + name + ".yaml"));
    std::string type, called;
    reader.field("type", type);
    reader.field("name", called);
    Khronos::Config config;
    read(reader, config);
    reader.finish();
    EXPECT_EQ(type, "khronos");
    EXPECT_EQ(called, name);
  }
}

TEST(Khronos, AtTenHertzEightObservationsMakeAnObject) {
  ConfigReader reader(ConfigDocument::fromFile(std::string(HYDRABENCH_SOURCE_DIR) +
                                               "/configs/methods/khronos_10hz.yaml"));
  Khronos::Config config;
  read(reader, config);
  MiniatureWorld world = roomWithBox();
  EXPECT_EQ(drive(world, fromAbove(7), config).objects.size(), 0u);
  EXPECT_EQ(drive(world, fromAbove(8), config).objects.size(), 1u);
}

TEST(Khronos, MotionDetectionNeedsFreeSpace) {
  ConfigReader reader(ConfigDocument::fromString("window: {track_freespace: false}"));
  Khronos::Config config;
  read(reader, config);
  EXPECT_THROW(reader.finish(), std::runtime_error);
}

}  // namespace
}  // namespace hydrabench

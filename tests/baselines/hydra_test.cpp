// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "baselines/hydra/hydra.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <numbers>
#include <set>
#include <string>
#include <tuple>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/parallel/parallel_for.h"
#include "tests/support/miniature_world.h"

namespace hydrabench {
namespace {

using Eigen::Vector3d;
using testing::Contains;
using testing::SizeIs;
namespace id = miniature_label;

void append(MiniatureWorld::Path& path, const MiniatureWorld::Path& more) {
  path.insert(path.end(), more.begin(), more.end());
}

std::int64_t after(const MiniatureWorld::Path& path) {
  return path.back().stamp_ns + kMiniaturePeriodNs;
}

SceneGraph mapped(MiniatureWorld& world, const MiniatureWorld::Path& path,
                  const Hydra::Config& config = {}) {
  Hydra hydra(config, miniatureLabelSpace());
  return world.drive(path, hydra);
}

/// Two chairs side by side in a room, `gap` apart.
SceneGraph twoChairs(double gap) {
  MiniatureWorld world;
  world.addRoom(6, 6, 2.5);
  const double y = 0.25 + gap / 2;
  world.add(transformed(pose(0, -y, 0, 0), tinyChair()), id::kChair, 1);
  world.add(transformed(pose(0, y, 0, 0), tinyChair()), id::kChair, 2);
  return mapped(world, orbitPath({0, 0, 0.4}, 2, 1.2, 40));
}

TEST(Hydra, JoinsChairsCloserThanTheClusterTolerance) {
  const SceneGraph graph = twoChairs(0.1);
  ASSERT_THAT(graph.objects, SizeIs(1));
  EXPECT_EQ(graph.objects[0].label, id::kChair);
  EXPECT_NEAR(graph.objects[0].box.sizes().y(), 1.1, 0.15);
}

TEST(Hydra, KeepsChairsApartThatAreFarther) {
  const SceneGraph graph = twoChairs(0.6);
  ASSERT_THAT(graph.objects, SizeIs(2));
  for (const ObjectNode& object : graph.objects) {
    EXPECT_EQ(object.label, id::kChair);
    EXPECT_NEAR(std::abs(object.box.center().y()), 0.55, 0.1);
    EXPECT_NEAR(object.box.max().z(), 0.9, 0.1);
    EXPECT_GT(surfaceArea(object.mesh), 0.5);
    EXPECT_LT(object.first_observed_ns, object.last_observed_ns);
  }
}

/// Sees 2.5 m far, forgets what is more than 3 m away.
Hydra::Config shortSighted() {
  Hydra::Config config;
  config.max_range_m = 2.5;
  config.window.radius_m = 3;
  return config;
}

TEST(Hydra, KeepsAnObjectWholeThatCrossesTheBorderOfTheWindow) {
  MiniatureWorld world;
  world.add(standingBox(8, 0.8, 0.8), id::kCouch, 1);
  MiniatureWorld::Path path;
  for (int i = 0; i < 60; ++i) {
    const double x = -4 + 8 * i / 59.0;
    append(path,
           stillPath({x, -2, 1.2}, {x, 0, 0.5}, 1, kMiniatureStartNs + i * kMiniaturePeriodNs));
  }
  Hydra hydra(shortSighted(), miniatureLabelSpace());
  for (const MiniatureWorld::View& view : path) {
    hydra.process(world.frame(view.T_world_camera, view.stamp_ns));
  }
  // Its first metres have left the window.
  for (const VertexId vertex : hydra.window().mesh().activeVertices()) {
    EXPECT_GT(hydra.window().mesh().position(vertex).x(), 0);
  }
  const SceneGraph graph = hydra.finish();
  ASSERT_THAT(graph.objects, SizeIs(1));
  EXPECT_NEAR(graph.objects[0].box.sizes().x(), 8, 0.2);
}

/// A chair from the front, then ten metres away, then the chair from behind.
SceneGraph chairSeenTwice(bool merge) {
  MiniatureWorld world;
  world.addRoom(30, 6, 2.5);
  world.add(tinyChair(), id::kChair, 1);
  MiniatureWorld::Path path = orbitPath({0, 0, 0.4}, 1.5, 1.1, 20, std::numbers::pi);
  append(path, stillPath({10, 0, 1}, {12, 0, 1}, 5, after(path)));
  MiniatureWorld::Path back = orbitPath({0, 0, 0.4}, 1.5, 1.1, 20, -std::numbers::pi, after(path));
  append(path, back);
  Hydra::Config config = shortSighted();
  config.objects.merge_revisited = merge;
  return mapped(world, path, config);
}

TEST(Hydra, JoinsAnObjectThatIsSeenAgainAfterTheWindowWasLeft) {
  const SceneGraph graph = chairSeenTwice(true);
  ASSERT_THAT(graph.objects, SizeIs(1));
  EXPECT_EQ(graph.objects[0].label, id::kChair);
  EXPECT_THAT(chairSeenTwice(false).objects, SizeIs(2));
}

TEST(Hydra, AConfusedFrameLeavesNoObjectOfTheWrongClass) {
  for (const int confused : {0, 12}) {
    MiniatureWorld world;
    world.addRoom(6, 6, 2.5);
    world.add(tinyChair(), id::kChair, 1);
    const MiniatureWorld::Path path = orbitPath({0, 0, 0.4}, 1.5, 1.1, 30);
    world.confuse(1, id::kPlant, path[static_cast<std::size_t>(confused)].stamp_ns);
    const SceneGraph graph = mapped(world, path);
    ASSERT_THAT(graph.objects, SizeIs(1)) << confused;
    EXPECT_EQ(graph.objects[0].label, id::kChair);
  }
}

TEST(Hydra, OfAChairSeenFromBehindTheSeatIsMissing) {
  // The eye is below the top of the back (0.9 m) and above the seat. It sees the rear face of the
  // back, x = -0.25, and from its outline the mesh goes back by the truncation distance at most, to
  // x = 0.05. Under the seat it sees the front legs up to 0.3 m. So there is nothing of the front
  // half of the seat, which lies from x = 0 to 0.25 at a height of 0.46 m.
  const auto on_seat = [](const SceneGraph& graph) {
    const auto& vertices = graph.objects.at(0).mesh.vertices;
    return std::count_if(vertices.begin(), vertices.end(),
                         [](const Vector3d& p) { return p.z() > 0.4 && p.x() > 0.1; });
  };
  MiniatureWorld world;
  world.addRoom(6, 6, 2.5);
  world.add(tinyChair(), id::kChair, 1);
  const SceneGraph behind = mapped(world, stillPath({-2, 0, 0.8}, {0, 0, 0.6}, 10));
  ASSERT_THAT(behind.objects, SizeIs(1));
  EXPECT_EQ(on_seat(behind), 0);
  EXPECT_NEAR(behind.objects[0].box.min().x(), -0.25, 0.05);
  EXPECT_NEAR(behind.objects[0].box.max().z(), 0.9, 0.1);
  EXPECT_GT(on_seat(mapped(world, orbitPath({0, 0, 0.4}, 1.5, 1.1, 30))), 10);
}

/// A room with a chair that moves along y, seen from a fixed place.
SceneGraph movingChair(const std::function<double(double frame)>& y, int num_frames) {
  MiniatureWorld world;
  world.addRoom(6, 6, 2.5);
  world.add(tinyChair(), id::kChair, 1, [&](std::int64_t stamp_ns) {
    const std::int64_t time_ns = stamp_ns - kMiniatureStartNs;
    return pose(0, y(static_cast<double>(time_ns) / kMiniaturePeriodNs), 0, 0);
  });
  return mapped(world, stillPath({2, 0, 1.2}, {0, 0, 0.5}, num_frames));
}

// Hydra tells what moves by its class only. With every frame a voxel inside a thing gains at least
// -0.11 m of weighted distance (0.15 m deep, where the drop-off leaves 0.75 of the weight), and one
// that is seen empty gains 0.3 m, the truncation distance; a surface is where the sum is negative.

TEST(Hydra, AChairOnItsWayIsNotMappedWhereItsPlaceIsMostlySeenEmpty) {
  // 5 cm a frame: no voxel is in the chair for more than 10 of the 30 frames, which takes 4 empty
  // ones to make up for. All but the start is seen empty before, and the start afterwards.
  const auto sideways = [](double frame) { return -1 + 0.05 * frame; };
  EXPECT_THAT(movingChair(sideways, 30).objects, SizeIs(0));
}

TEST(Hydra, AChairThatWasCarriedAwayIsAtItsOldPlaceThenNowhereThenAtItsNewPlace) {
  // It stands at y = -1 for 8 frames and at y = 1 afterwards. The old place has gone after
  // 8 * 0.11 / 0.3 = 3 frames, at the latest. At the new place nothing shows for the first
  // 8 * 0.3 / 0.11 = 21 frames, and 5 cm behind the surface it takes 8 * 0.3 / 0.05 = 48.
  const auto carried = [](double frame) { return frame < 8 ? -1.0 : 1.0; };
  const SceneGraph at_first = movingChair(carried, 8 + 1);
  ASSERT_THAT(at_first.objects, SizeIs(1));
  EXPECT_NEAR(at_first.objects[0].box.center().y(), -1, 0.1);
  EXPECT_THAT(movingChair(carried, 8 + 12).objects, SizeIs(0));
  const SceneGraph at_last = movingChair(carried, 8 + 60);
  ASSERT_THAT(at_last.objects, SizeIs(1));
  EXPECT_NEAR(at_last.objects[0].box.center().y(), 1, 0.1);
}

TEST(Hydra, InstanceIdsThatChangeEveryFrameDoNotMatter) {
  const auto run = [](bool flickering) {
    MiniatureWorld world;
    world.addRoom(6, 6, 2.5);
    world.add(transformed(pose(0, -0.6, 0, 0), tinyChair()), id::kChair, 1);
    world.add(transformed(pose(0, 0.6, 0, 0), tinyChair()), id::kChair, 2);
    if (flickering) world.shuffleInstanceIds();
    return mapped(world, orbitPath({0, 0, 0.4}, 2, 1.2, 20));
  };
  const SceneGraph steady = run(false);
  const SceneGraph flickering = run(true);
  ASSERT_THAT(steady.objects, SizeIs(2));
  ASSERT_EQ(steady.objects.size(), flickering.objects.size());
  for (std::size_t i = 0; i < steady.objects.size(); ++i) {
    EXPECT_EQ(steady.objects[i].id, flickering.objects[i].id);
    EXPECT_EQ(steady.objects[i].mesh.vertices, flickering.objects[i].mesh.vertices);
    EXPECT_EQ(steady.objects[i].mesh.faces, flickering.objects[i].mesh.faces);
  }
  EXPECT_EQ(steady.scene_mesh.vertices, flickering.scene_mesh.vertices);
  EXPECT_EQ(steady.scene_labels, flickering.scene_labels);
}

TEST(Hydra, KeepsClassesThatMoveOutOfTheMapEvenAtRest) {
  MiniatureWorld world;
  world.addRoom(6, 6, 2.5);
  world.add(transformed(pose(1, 0, 0, 0), standingBox(0.5, 0.5, 1.7)), id::kHuman, 1);
  const SceneGraph graph = mapped(world, stillPath({-1, 0, 1}, {1, 0, 1}, 10));
  EXPECT_THAT(graph.scene_labels, Contains(id::kWall));
  EXPECT_THAT(graph.scene_labels, testing::Not(Contains(id::kHuman)));
}

using Corners = std::vector<std::tuple<double, double, double>>;

Corners cornersOf(const Mesh& mesh, const Eigen::Vector3i& face) {
  Corners corners;
  for (int k = 0; k < 3; ++k) {
    const Vector3d& p = mesh.vertices[static_cast<std::size_t>(face[k])];
    corners.emplace_back(p.x(), p.y(), p.z());
  }
  return corners;
}

TEST(Hydra, AnObjectsMeshIsTheFacesOfTheSceneWithAllThreeCornersInItsNode) {
  MiniatureWorld world;
  world.addRoom(6, 6, 2.5);
  world.add(tinyChair(), id::kChair, 1);
  Hydra hydra({}, miniatureLabelSpace());
  const SceneGraph graph = world.drive(orbitPath({0, 0, 0.4}, 1.5, 1.1, 30), hydra);
  ASSERT_THAT(hydra.objects().nodes(), SizeIs(1));
  std::set<std::tuple<double, double, double>> of_node;
  for (const VertexId vertex : hydra.objects().nodes()[0].vertices) {
    const Vector3d& p = hydra.window().mesh().position(vertex);
    of_node.emplace(p.x(), p.y(), p.z());
  }
  std::vector<Corners> expected;
  for (const Eigen::Vector3i& face : graph.scene_mesh.faces) {
    const Corners corners = cornersOf(graph.scene_mesh, face);
    if (std::all_of(corners.begin(), corners.end(),
                    [&](const auto& corner) { return of_node.count(corner) > 0; })) {
      expected.push_back(corners);
    }
  }
  std::vector<Corners> faces;
  const Mesh& mesh = graph.objects[0].mesh;
  for (const Eigen::Vector3i& face : mesh.faces) faces.push_back(cornersOf(mesh, face));
  EXPECT_GT(faces.size(), 100u);
  EXPECT_LT(faces.size(), graph.scene_mesh.faces.size());
  EXPECT_EQ(faces, expected);
}

TEST(Hydra, AnObjectWithoutAFaceHasTheBoxOfItsVertices) {
  // A strip on a wall, one voxel wide: its vertices form a line, and no triangle is all its own.
  Frame frame;
  frame.stamp_ns = kMiniatureStartNs;
  frame.camera = miniatureCamera();
  frame.T_world_camera = lookAt({0, 0, 0}, {0, 1, 0});
  frame.depth = Image<float>(frame.camera.width, frame.camera.height, 2);
  frame.labels = Image<Label>(frame.camera.width, frame.camera.height, id::kWall);
  for (int v = 0; v < frame.camera.height; ++v) {
    for (int u = 0; u < frame.camera.width; ++u) {
      const double x = frame.camera.backproject(u, v, 2).x();
      if (x > 0 && x < 0.1) frame.labels(u, v) = id::kChair;
    }
  }
  Hydra::Config config;
  config.objects.min_cluster_size = 10;
  Hydra hydra(config, miniatureLabelSpace());
  hydra.process(frame);
  const SceneGraph graph = hydra.finish();
  ASSERT_THAT(graph.objects, SizeIs(1));
  EXPECT_TRUE(graph.objects[0].mesh.empty());
  EXPECT_NEAR(graph.objects[0].box.center().x(), 0.05, 1e-3);
  EXPECT_NEAR(graph.objects[0].box.center().y(), 2, 1e-2);
  EXPECT_GT(graph.objects[0].box.sizes().z(), 2);
}

TEST(Hydra, GivesTheSameGraphForAnyNumberOfThreads) {
  std::vector<SceneGraph> graphs;
  for (const int threads : {1, 2}) {
    setNumThreads(threads);
    graphs.push_back(twoChairs(0.6));
  }
  setNumThreads(0);
  ASSERT_EQ(graphs[0].objects.size(), graphs[1].objects.size());
  for (std::size_t i = 0; i < graphs[0].objects.size(); ++i) {
    EXPECT_EQ(graphs[0].objects[i].mesh.vertices, graphs[1].objects[i].mesh.vertices);
    EXPECT_EQ(graphs[0].objects[i].mesh.faces, graphs[1].objects[i].mesh.faces);
    EXPECT_EQ(graphs[0].objects[i].name, graphs[1].objects[i].name);
  }
  EXPECT_EQ(graphs[0].scene_mesh.vertices, graphs[1].scene_mesh.vertices);
  EXPECT_EQ(graphs[0].scene_mesh.colors, graphs[1].scene_mesh.colors);
  EXPECT_EQ(graphs[0].scene_labels, graphs[1].scene_labels);
}

TEST(Hydra, FindsAtTheEndWhatItSawSinceTheLastUpdate) {
  MiniatureWorld world;
  world.add(tinyChair(), id::kChair, 1);
  MiniatureWorld::Path path = stillPath({1.5, 0, 1}, {9, 0, 1}, 1);  // looks away
  append(path, stillPath({1.5, 0, 1}, {0, 0, 0.4}, 1, after(path)));
  Hydra::Config config;
  config.window.output_separation_s = 10;
  EXPECT_THAT(mapped(world, path, config).objects, SizeIs(1));
}

/// What a method reads of a file, written out in full.
std::string resolved(const ConfigDocument& document, Hydra::Config& config) {
  ConfigReader reader(document);
  std::string word;
  reader.field("type", word);
  reader.field("name", word);
  read(reader, config);
  reader.finish();
  return reader.resolved();
}

ConfigDocument published(const std::string& name) {
  return ConfigDocument::fromFile(std::string(HYDRABENCH_SOURCE_DIR) + "/configs/methods/" + name);
}

TEST(Hydra, HasThePublishedValuesOfUHumans2AsDefaults) {
  Hydra::Config from_file;
  Hydra::Config defaults;
  EXPECT_EQ(resolved(published("hydra.yaml"), from_file),
            resolved(ConfigDocument::fromString("{type: hydra, name: hydra}"), defaults));
}

TEST(Hydra, ReadsItsOtherPublishedConfigs) {
  Hydra::Config kimera;
  resolved(published("hydra_kimera_multi_rgbd.yaml"), kimera);
  EXPECT_EQ(kimera.window.tsdf.semantics.type, "mle");
  EXPECT_EQ(kimera.window.mesh_min_weight, 0.5);
  EXPECT_EQ(kimera.objects.min_cluster_size, 20);
  Hydra::Config outdoor;
  resolved(published("hydra_d455_outdoor.yaml"), outdoor);
  EXPECT_EQ(outdoor.window.radius_m, 15);
  EXPECT_EQ(outdoor.objects.cluster_tolerance_m, 0.18);
}

TEST(Hydra, TimesItsStages) {
  MiniatureWorld world;
  world.add(tinyChair(), id::kChair, 1);
  Hydra hydra({}, miniatureLabelSpace());
  world.drive(stillPath({1.5, 0, 1}, {0, 0, 0.4}, 3), hydra);
  std::vector<std::string> names;
  for (const StageTimes::Stage& stage : hydra.stageTimes().stages()) names.push_back(stage.name);
  EXPECT_THAT(names, testing::UnorderedElementsAre("integrate", "mesh", "objects"));
}

}  // namespace
}  // namespace hydrabench

// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "baselines/template_cad/template_cad.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "baselines/template_cad/footprint.h"
#include "core/geometry/mesh_io.h"
#include "core/graph/spark_dsg_json.h"
#include "core/parallel/parallel_for.h"
#include "core/types/error.h"
#include "tests/support/miniature_world.h"
#include "tests/support/temporary_folder.h"

namespace hydrabench {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using ::testing::HasSubstr;
namespace id = miniature_label;

constexpr double kPi = std::numbers::pi;
constexpr std::int64_t kSecond = 1'000'000'000;

// ---------------------------------------------------------------- footprints

std::vector<Vector3d> outline(double length, double width, double yaw, const Vector2d& center) {
  std::vector<Vector3d> points;
  const Transform T = pose(center.x(), center.y(), 0, yaw);
  for (int i = 0; i <= 20; ++i) {
    for (int j = 0; j <= 20; ++j) {
      points.push_back(T * Vector3d(length * (i / 20.0 - 0.5), width * (j / 20.0 - 0.5), 0.01 * i));
    }
  }
  return points;
}

TEST(Footprint, TheMainAxisIsFoundModuloHalfATurn) {
  for (const double degrees : {0.0, 20.0, 90.0, 135.0, 179.0, 200.0, -30.0}) {
    const double yaw = degrees * kPi / 180;
    const auto footprint = footprintOf(outline(1.8, 0.8, yaw, {2, -1}));
    ASSERT_TRUE(footprint);
    EXPECT_GE(footprint->yaw, 0);
    EXPECT_LT(footprint->yaw, kPi);
    EXPECT_NEAR(std::remainder(footprint->yaw - yaw, kPi), 0, 1e-9);
    EXPECT_NEAR(footprint->length, 1.8, 1e-9);
    EXPECT_NEAR(footprint->width, 0.8, 1e-9);
    EXPECT_NEAR((footprint->center - Vector2d(2, -1)).norm(), 0, 1e-9);
  }
}

TEST(Footprint, DoesNotDependOnWhichSideHasMorePoints) {
  std::vector<Vector3d> points = outline(1.8, 0.8, 0.3, {0, 0});
  const Transform T = pose(0, 0, 0, 0.3);
  for (int i = 0; i < 1000; ++i) points.push_back(T * Vector3d(0.9 - 1e-4 * i, 0.4, 0));
  EXPECT_NEAR(footprintOf(points)->yaw, 0.3, 1e-9);
}

TEST(Footprint, PointsOnALineHaveNone) {
  const std::vector<Vector3d> line = {{0, 0, 0}, {1, 1, 0}, {2, 2, 1}, {3, 3, 0}};
  EXPECT_FALSE(footprintOf(line));
  EXPECT_FALSE(footprintOf(std::vector<Vector3d>{}));
}

// ---------------------------------------------------------------- templates

/// 1.8 m wide, 0.8 m deep, 0.9 m high, with the back at -x: its front is known.
Mesh tinyCouch() {
  Mesh couch = boxMesh(Aabb(Vector3d(-0.4, -0.9, 0), Vector3d(0.4, 0.9, 0.4)));
  append(boxMesh(Aabb(Vector3d(-0.4, -0.9, 0.4), Vector3d(-0.2, 0.9, 0.9))), couch);
  return couch;
}

std::vector<Vector3d> pointsOn(const Mesh& mesh) {
  std::vector<Vector3d> points;
  for (const Eigen::Vector3i& face : mesh.faces) {
    for (int i = 0; i <= 8; ++i) {
      for (int j = 0; i + j <= 8; ++j) {
        const double u = i / 8.0;
        const double v = j / 8.0;
        points.push_back((1 - u - v) * mesh.vertices[static_cast<std::size_t>(face[0])] +
                         u * mesh.vertices[static_cast<std::size_t>(face[1])] +
                         v * mesh.vertices[static_cast<std::size_t>(face[2])]);
      }
    }
  }
  return points;
}

TEST(TemplateModel, StandsWithTheMiddleOfItsFootprintAtTheLandmark) {
  const TemplateModel model(transformed(pose(7, 8, 9, 0), tinyCouch()));
  const auto points = outline(1.0, 0.5, 0, {2, 3});
  const auto placed = model.place({.position = "centroid", .yaw = "fixed"}, Vector2d(5, -6),
                                  *footprintOf(points), points);
  EXPECT_NEAR((bounds(placed.mesh).min() - Vector3d(4.6, -6.9, 0)).norm(), 0, 1e-12);
  EXPECT_NEAR((bounds(placed.mesh).max() - Vector3d(5.4, -5.1, 0.9)).norm(), 0, 1e-12);
  const auto in_the_middle = model.place({.position = "mid_extent", .yaw = "fixed"},
                                         Vector2d(5, -6), *footprintOf(points), points);
  EXPECT_NEAR((bounds(in_the_middle.mesh).center() - Vector3d(2, 3, 0.45)).norm(), 0, 1e-12);
}

TEST(TemplateModel, MayHangAtTheHeightOfThePoints) {
  const TemplateModel model(standingBox(0.2, 0.4, 0.6));
  const std::vector<Vector3d> points = {{0, 0, 1}, {1, 0, 2}, {0, 1, 3}};
  const auto placed =
      model.place({.yaw = "fixed", .z = "centroid"}, Vector2d(0, 0), *footprintOf(points), points);
  EXPECT_NEAR(bounds(placed.mesh).center().z(), 2, 1e-12);
}

TEST(TemplateModel, MayStandOnTheLowestOfThePoints) {
  const TemplateModel model(standingBox(0.2, 0.4, 0.6));
  std::vector<Vector3d> points = {{0, 0, -3}, {1, 0, 7}, {0, 1, 7}};  // one leaked
  for (int i = 0; i < 97; ++i) points.emplace_back(0.01 * i, 0.5, 5 + 0.01 * i);
  const auto placed =
      model.place({.yaw = "fixed", .z = "lowest"}, Vector2d(0, 0), *footprintOf(points), points);
  EXPECT_NEAR(bounds(placed.mesh).min().z(), 5.04, 1e-9);
}

TEST(TemplateModel, TheLongerSideGoesAlongTheFootprint) {
  const TemplateModel model(tinyCouch());
  const double yaw = 0.6;
  const auto points = pointsOn(transformed(pose(1, 2, 0, yaw), tinyCouch()));
  const auto placed =
      model.place({.yaw = "hull_pca"}, Vector2d(1, 2), *footprintOf(points), points);
  const Vector3d front = placed.T_world_object.linear().col(0);
  EXPECT_NEAR(std::remainder(std::atan2(front.y(), front.x()) - yaw, kPi), 0, 1e-9);
}

TEST(TemplateModel, TheSearchTellsFrontFromBack) {
  const TemplateModel model(tinyCouch());
  for (const double degrees : {40.0, 220.0}) {
    const double yaw = degrees * kPi / 180;
    const auto points = pointsOn(transformed(pose(1, 2, 0, yaw), tinyCouch()));
    const auto placed = model.place({.yaw = "chamfer_search", .yaw_step_deg = 10}, Vector2d(1, 2),
                                    *footprintOf(points), points);
    const Vector3d front = placed.T_world_object.linear().col(0);
    EXPECT_NEAR(std::remainder(std::atan2(front.y(), front.x()) - yaw, 2 * kPi), 0, 1e-9);
  }
}

TEST(TemplateModel, MayBeStretchedToTheExtents) {
  const TemplateModel model(tinyCouch());
  const auto points = pointsOn(transformed(pose(1, 2, 0, 0), standingBox(1.0, 2.0, 0.6)));
  const auto placed = model.place({.yaw = "fixed", .scale = "fitted_to_extents"}, Vector2d(1, 2),
                                  *footprintOf(points), points);
  EXPECT_NEAR((bounds(placed.mesh).sizes() - Vector3d(1.0, 2.0, 0.6)).norm(), 0, 1e-9);
}

// ---------------------------------------------------------------- the whole method

class TemplateCadRun : public ::testing::Test {
 protected:
  TemplateCadRun() {
    writeMesh(folder_ / "chair.ply", tinyChair());
    writeMesh(folder_ / "couch.ply", tinyCouch());
    for (const std::string name : {"chair", "couch"}) {
      TemplateCad::ClassRules rules = TemplateCad::publishedRules(name);
      rules.mesh = folder_ / (name + ".ply");
      config_.templates.push_back(rules);
    }
    config_.measurement.min_extent_m = 0.1;
    world_.addRoom(6, 6, 2.5);
  }

  void addChair(double x, double y, double yaw, InstanceId object) {
    world_.add(transformed(pose(x, y, 0, yaw), tinyChair()), id::kChair, object);
  }
  SceneGraph drive(const MiniatureWorld::Path& path) {
    TemplateCad method(config_, miniatureLabelSpace());
    return world_.drive(path, method);
  }
  /// Around the middle of the room.
  MiniatureWorld::Path around() const { return orbitPath({0, 0, 0.5}, 2.2, 1.4, 40); }

  TemporaryFolder folder_;
  TemplateCad::Config config_;
  MiniatureWorld world_;
};

TEST_F(TemplateCadRun, AChairBecomesTheTemplateWhereTheChairStands) {
  addChair(0.2, -0.1, 0, 1);
  const SceneGraph graph = drive(around());
  ASSERT_EQ(graph.objects.size(), 1u);
  const ObjectNode& object = graph.objects[0];
  EXPECT_EQ(object.id, objectNodeId(0));
  EXPECT_EQ(object.label, id::kChair);
  EXPECT_EQ(object.name, "chair");
  EXPECT_EQ(object.mesh.faces.size(), tinyChair().faces.size());
  EXPECT_NEAR((object.box.center().head<2>() - Vector2d(0.2, -0.1)).norm(), 0, 0.1);
  EXPECT_NEAR(object.box.min().z(), 0, 1e-6);
  EXPECT_EQ(object.first_observed_ns, kMiniatureStartNs);
  EXPECT_EQ(object.last_observed_ns, kMiniatureStartNs + 39 * kMiniaturePeriodNs);
  EXPECT_TRUE(graph.scene_mesh.empty());
}

TEST_F(TemplateCadRun, ChairsNearerThanTheGateStayTwo) {
  addChair(-0.3, 0, 0, 1);
  addChair(0.3, 0, 0, 2);
  const SceneGraph graph = drive(around());
  ASSERT_EQ(graph.objects.size(), 2u);
  double first = graph.objects[0].box.center().x();
  double second = graph.objects[1].box.center().x();
  if (first > second) std::swap(first, second);
  EXPECT_NEAR(first, -0.3, 0.12);
  EXPECT_NEAR(second, 0.3, 0.12);
}

TEST_F(TemplateCadRun, IdsThatChangeEveryFrameDoNotMatter) {
  addChair(-0.5, 0, 0, 1);
  addChair(0.5, 0.2, 1, 2);
  addChair(0, -0.9, 2, 3);
  addChair(0.1, 0.9, 3, 4);
  const SceneGraph steady = drive(around());
  world_.shuffleInstanceIds();
  const SceneGraph shuffled = drive(around());
  ASSERT_EQ(shuffled.objects.size(), steady.objects.size());
  for (std::size_t i = 0; i < steady.objects.size(); ++i) {
    EXPECT_EQ(shuffled.objects[i].mesh.vertices, steady.objects[i].mesh.vertices);
  }
}

TEST_F(TemplateCadRun, AFrameWithTheWrongClassMakesNoObject) {
  addChair(0, 0, 0, 1);
  world_.confuse(1, id::kCouch, kMiniatureStartNs + 5 * kMiniaturePeriodNs);
  const SceneGraph graph = drive(around());
  ASSERT_EQ(graph.objects.size(), 1u);
  EXPECT_EQ(graph.objects[0].label, id::kChair);
}

TEST_F(TemplateCadRun, AnObjectSeenAgainAfterAMinuteIsOne) {
  addChair(0, 0, 0, 1);
  MiniatureWorld::Path path = around();
  for (const auto& view :
       orbitPath({0, 0, 0.5}, 2.0, 1.2, 40, 2 * kPi, kMiniatureStartNs + 64 * kSecond)) {
    path.push_back(view);
  }
  EXPECT_EQ(drive(path).objects.size(), 1u);
}

TEST_F(TemplateCadRun, SomethingAsLongAsNoChairIsNoChair) {
  world_.add(transformed(pose(0, 0, 0, 0), standingBox(0.4, 2.0, 0.8)), id::kChair, 1);
  EXPECT_TRUE(drive(around()).objects.empty());
}

TEST_F(TemplateCadRun, AnElongatedThingGivesItsYaw) {
  const double yaw = 0.5;
  world_.add(transformed(pose(0, 0, 0, yaw), standingBox(0.8, 1.8, 0.8)), id::kCouch, 1);
  const SceneGraph graph = drive(around());
  ASSERT_EQ(graph.objects.size(), 1u);
  const Vector3d front = graph.objects[0].T_world_object.linear().col(0);
  EXPECT_NEAR(std::remainder(std::atan2(front.y(), front.x()) - yaw, kPi), 0, 0.1);
}

TEST_F(TemplateCadRun, AClassWithoutATemplateGivesNoObjectAndANote) {
  world_.add(standingBox(0.5, 0.5, 0.5), id::kComputer, 1);
  TemplateCad method(config_, miniatureLabelSpace());
  EXPECT_TRUE(world_.drive(around(), method).objects.empty());
  ASSERT_EQ(method.notes().size(), 3u);
  EXPECT_EQ(method.notes()[0], "one template per class: chair (chair.ply), couch (couch.ply)");
  EXPECT_THAT(method.notes()[1], HasSubstr("yaw"));
  EXPECT_THAT(method.notes()[1], HasSubstr("on the ground, whose height is given: 0 m"));
  EXPECT_EQ(method.notes()[2], "no template, no objects: computer, plant, bin");
}

TEST_F(TemplateCadRun, ATemplateOfAClassThatIsNoObjectGivesANote) {
  for (const std::string name : {"sofa", "wall"}) {
    config_.templates.push_back(config_.templates[0]);
    config_.templates.back().class_name = name;
  }
  const auto notes = TemplateCad(config_, miniatureLabelSpace()).notes();
  ASSERT_EQ(notes.size(), 4u);
  EXPECT_EQ(notes[3], "templates of classes that are no objects of this dataset: sofa, wall");
}

TEST_F(TemplateCadRun, NothingNearerThanTheLeastRangeCounts) {
  addChair(0, 0, 0, 1);
  config_.min_range_m = 4;  // from 2.2 m no part of it is as far
  EXPECT_TRUE(drive(around()).objects.empty());
}

/// A box of 0.5 x 0.5 m that turns a corner to a camera at +x and at half its height. Two of its
/// faces are seen, and depth grows evenly along them from the corner: between the 35th and the 45th
/// percentile there are a strip on each, 0.35 to 0.45 of the face from the corner, i.e. 0.5 * 0.4 *
/// cos(45) = 0.14 m behind the corner, which is 0.354 m before the middle. Farther columns are
/// lower in the image: a little nearer still.
constexpr double kSeenBefore = 0.354 - 0.14;
Mesh cornerAhead(double y) {
  return transformed(pose(0, y, 0, kPi / 4), standingBox(0.5, 0.5, 0.8));
}

TEST_F(TemplateCadRun, AThingSeenFromOneSideStandsTooNearByAboutHalfItself) {
  world_.add(cornerAhead(0), id::kChair, 1);
  const SceneGraph graph = drive(stillPath({2.2, 0, 0.4}, {0, 0, 0.4}, 10));
  ASSERT_EQ(graph.objects.size(), 1u);
  const Vector3d middle = graph.objects[0].T_world_object.translation();
  EXPECT_NEAR(middle.x(), kSeenBefore, 0.03);
  EXPECT_NEAR(middle.y(), 0, 0.03);
  EXPECT_EQ(graph.objects[0].mesh.faces.size(), tinyChair().faces.size());  // whole nevertheless
}

TEST_F(TemplateCadRun, AThingSeenFlatFromOneSideHasNoFootprint) {
  world_.add(standingBox(0.5, 0.5, 0.8), id::kChair, 1);
  EXPECT_TRUE(drive(stillPath({2.2, 0, 0.4}, {0, 0, 0.4}, 10)).objects.empty());
}

TEST_F(TemplateCadRun, AMovingThingIsOneInTheMiddleOfItsWayUnlessTheWayIsTooLong) {
  // 5 cm a frame: the moving average lags by 5 cm * (1 - 0.1) / 0.1 = 0.45 m, within the gate of
  // 0.75 m: one track. Its points extend over the way and the 0.32 m between the strips: 0.92 m of
  // 0.6 m, where the middle is the way's; of 2 m more than the 1.5 m that a chair may have.
  for (const double way : {0.6, 2.0}) {
    MiniatureWorld world;
    world.add(cornerAhead(-0.5 * way), id::kChair, 1, [](std::int64_t stamp_ns) {
      return pose(0, 0.5e-9 * static_cast<double>(stamp_ns - kMiniatureStartNs), 0, 0);
    });
    TemplateCad method(config_, miniatureLabelSpace());
    const int num_views = 1 + static_cast<int>(std::lround(way / 0.05));
    const SceneGraph graph = world.drive(stillPath({2.2, 0, 0.4}, {0, 0, 0.4}, num_views), method);
    if (way > 1) {
      EXPECT_TRUE(graph.objects.empty());
      continue;
    }
    ASSERT_EQ(graph.objects.size(), 1u);
    const Vector3d middle = graph.objects[0].T_world_object.translation();
    EXPECT_NEAR(middle.x(), kSeenBefore, 0.05);
    EXPECT_NEAR(middle.y(), 0, 0.05);
  }
}

TEST_F(TemplateCadRun, ConnectedSemanticsReplaceTheInstanceImage) {
  addChair(0, 0, 0, 1);
  Frame frame = world_.frame(around()[0].T_world_camera, kSecond);
  frame.instances = {};
  TemplateCad needs_instances(config_, miniatureLabelSpace());
  EXPECT_THAT(messageOf<InputError>([&] { needs_instances.process(frame); }),
              HasSubstr("candidates.source: connected_semantics"));
  config_.candidates.source = "connected_semantics";
  TemplateCad method(config_, miniatureLabelSpace());
  for (int i = 0; i < 10; ++i) {
    frame.stamp_ns += kMiniaturePeriodNs;
    method.process(frame);
  }
  EXPECT_EQ(method.finish().objects.size(), 1u);
}

TEST_F(TemplateCadRun, ThreadsDoNotMatter) {
  addChair(-0.5, 0, 0, 1);
  addChair(0.5, 0.2, 1, 2);
  config_.placement.yaw = "chamfer_search";
  setNumThreads(1);
  const SceneGraph one = drive(around());
  setNumThreads(4);
  const SceneGraph four = drive(around());
  setNumThreads(0);
  ASSERT_EQ(one.objects.size(), four.objects.size());
  for (std::size_t i = 0; i < one.objects.size(); ++i) {
    EXPECT_EQ(one.objects[i].mesh.vertices, four.objects[i].mesh.vertices);
  }
}

TEST_F(TemplateCadRun, ASecondTemplateForAClassIsAFault) {
  const std::string chair = (folder_ / "chair.ply").string();
  ConfigReader reader(ConfigDocument::fromString("templates: [{class: chair, mesh: " + chair +
                                                 "}, {class: chair, mesh: " + chair + "}]"));
  TemplateCad::Config config;
  read(reader, config);
  EXPECT_THAT(messageOf<InputError>([&] { reader.finish(); }),
              HasSubstr("chair has a template already; expected one per class"));
}

TEST_F(TemplateCadRun, TheLeastRangeIsBelowTheGreatest) {
  ConfigReader reader(ConfigDocument::fromString("{min_range_m: 2, candidates: {max_range_m: 1}}"));
  TemplateCad::Config config;
  read(reader, config);
  EXPECT_THAT(messageOf<InputError>([&] { reader.finish(); }), HasSubstr("min_range_m"));
}

TEST(TemplateCadConfig, IsReadFromTheFileThatComesWithIt) {
  ConfigReader reader(ConfigDocument::fromFile(std::string(HYDRABENCH_SOURCE_DIR) +
                                               "/configs/methods/template_cad.yaml"));
  std::string ignored;  // the method table reads these two
  reader.field("type", ignored);
  reader.field("name", ignored);
  TemplateCad::Config config;
  read(reader, config);
  reader.finish();
  ASSERT_EQ(config.templates.size(), 4u);
  EXPECT_EQ(config.templates[0].class_name, "chair");
  EXPECT_EQ(config.templates[0].gate_m, 0.75);
  for (const auto& rules : config.templates) {
    EXPECT_TRUE(std::filesystem::exists(rules.mesh)) << rules.mesh;
  }
}

}  // namespace
}  // namespace hydrabench

// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include <cmath>
#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/graph/spark_dsg_json.h"
#include "core/types/error.h"
#include "core/types/random.h"
#include "tests/support/temporary_folder.h"

namespace hydrabench {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

Transform somePose(std::uint64_t seed) {
  Random random(seed);
  const Eigen::Vector3d axis =
      Eigen::Vector3d(random.normal(), random.normal(), random.normal()).normalized();
  Transform pose = Transform::Identity();
  pose.linear() = Eigen::AngleAxisd(random.uniform(0, 3), axis).toRotationMatrix();
  pose.translation() = Eigen::Vector3d(random.uniform(-30, 30), random.uniform(-1, 1), 0.3);
  return pose;
}

/// Many vertices whose coordinates share no grid: near zero, far away, of either sign.
Mesh awkwardMesh(std::uint64_t seed) {
  Mesh mesh = transformed(somePose(seed), sphereMesh({0.1, 0.2, 0.3}, 0.7, 2));
  mesh.vertices[0].x() = 1e-17;
  mesh.vertices[1].y() = -0.0;
  mesh.vertices[2].z() = std::numeric_limits<double>::denorm_min();
  return mesh;
}

SceneGraph someGraph() {
  SceneGraph graph;
  graph.label_space.entries = {{0, "unknown", {32, 32, 32}, false, false},
                               {5, "chair \"x\"\n", {102, 255, 0}, true, true},
                               {7, "couch", {39, 144, 65}, true, false}};
  for (std::uint64_t i = 0; i < 5; ++i) {
    ObjectNode object;
    object.id = i == 4 ? std::numeric_limits<ObjectId>::max() : objectNodeId(i);
    object.label = i % 2 ? 5 : 7;
    object.name = "object_" + std::to_string(i);
    object.T_world_object = somePose(100 + i);
    object.scale = 1.0 / (3.0 + static_cast<double>(i));
    object.mesh = awkwardMesh(i);
    if (i == 2) {
      Random random(9);
      for (std::size_t k = 0; k < object.mesh.vertices.size(); ++k) {
        object.mesh.colors.push_back({static_cast<std::uint8_t>(random.index(256)), 3, 255});
      }
    }
    object.box = bounds(object.mesh);
    object.first_observed_ns = 1'700'000'000'123'456'789;
    object.last_observed_ns = std::numeric_limits<std::int64_t>::max();
    graph.objects.push_back(object);
  }
  graph.scene_mesh = awkwardMesh(50);
  graph.scene_labels.assign(graph.scene_mesh.vertices.size(), 7);
  return graph;
}

void expectSameBits(const Mesh& a, const Mesh& b) {
  ASSERT_EQ(a.vertices.size(), b.vertices.size());
  for (std::size_t i = 0; i < a.vertices.size(); ++i) EXPECT_EQ(a.vertices[i], b.vertices[i]) << i;
  EXPECT_EQ(a.faces, b.faces);
  EXPECT_EQ(a.colors, b.colors);
}

TEST(SparkDsg, EverythingReadsBackBitEqual) {
  TemporaryFolder folder;
  const SceneGraph graph = someGraph();
  writeSparkDsg(folder / "g.json", graph);
  const SceneGraph read = readSparkDsg(folder / "g.json");
  ASSERT_EQ(read.objects.size(), graph.objects.size());
  for (std::size_t i = 0; i < graph.objects.size(); ++i) {
    const ObjectNode& a = graph.objects[i];
    const ObjectNode& b = read.objects[i];
    EXPECT_EQ(a.id, b.id);
    EXPECT_EQ(a.label, b.label);
    EXPECT_EQ(a.name, b.name);
    EXPECT_EQ(a.scale, b.scale);
    EXPECT_EQ(a.T_world_object.matrix(), b.T_world_object.matrix());
    EXPECT_EQ(a.first_observed_ns, b.first_observed_ns);
    EXPECT_EQ(a.last_observed_ns, b.last_observed_ns);
    EXPECT_EQ(a.box.min(), b.box.min());
    EXPECT_EQ(a.box.max(), b.box.max());
    expectSameBits(a.mesh, b.mesh);
  }
  expectSameBits(graph.scene_mesh, read.scene_mesh);
  EXPECT_EQ(graph.scene_labels, read.scene_labels);
  ASSERT_EQ(read.label_space.entries.size(), 3u);
  EXPECT_EQ(read.label_space.entries[1].name, "chair \"x\"\n");
  EXPECT_EQ(read.label_space.entries[1].color, (Rgb{102, 255, 0}));
  EXPECT_TRUE(read.label_space.entries[1].is_scored);
  EXPECT_TRUE(read.label_space.entries[2].is_object);
  EXPECT_FALSE(read.label_space.entries[2].is_scored);
}

TEST(SparkDsg, WritingAgainGivesTheSameBytes) {
  TemporaryFolder folder;
  writeSparkDsg(folder / "a.json", someGraph());
  writeSparkDsg(folder / "b.json", readSparkDsg(folder / "a.json"));
  EXPECT_EQ(readText(folder / "a.json"), readText(folder / "b.json"));
}

TEST(SparkDsg, TheFileHasWhatTheLibraryAsksFor) {
  TemporaryFolder folder;
  SceneGraph graph = someGraph();
  graph.objects.resize(1);
  writeSparkDsg(folder / "g.json", graph);
  const std::string text = readText(folder / "g.json");
  for (const char* part :
       {R"("SPARK_DSG_header":{"project_name":"main","version":{"major":1,"minor":1,"patch":3}})",
        R"("directed":false)", R"("multigraph":false)",
        R"("layer_keys":[{"layer":2,"partition":0})", R"("OBJECTS":{"layer":2,"partition":0})",
        R"("labelspaces":{"_l2p0":[[0,"unknown"],[5,)",
        R"("id":5692549928996306944,"layer":2,"partition":0)",
        R"("type":"KhronosObjectAttributes")", R"("bounding_box":{"type":"AABB","dimensions":[)",
        R"("world_R_center":{"w":1,"x":0,"y":0,"z":0})", R"("world_R_object":{"w":)",
        R"("semantic_label":7,"color":{"r":39,"g":144,"b":65,"a":255})",
        R"("first_observed_ns":[1700000000123456789])", R"("edges":[])",
        R"("mesh":{"header":{"project_name":"main")"}) {
    EXPECT_THAT(text, HasSubstr(part));
  }
}

TEST(SparkDsg, PositionIsTheBoxCenterWhateverTheOriginOfTheObject) {
  TemporaryFolder folder;
  SceneGraph graph;
  ObjectNode object;
  object.id = objectNodeId(0);
  object.mesh = boxMesh(Aabb(Eigen::Vector3d(1, 2, 3), Eigen::Vector3d(2, 4, 6)));
  graph.objects.push_back(object);
  writeSparkDsg(folder / "g.json", graph);
  EXPECT_THAT(readText(folder / "g.json"), HasSubstr(R"("position":[1.5,3,4.5])"));
  EXPECT_THAT(readText(folder / "g.json"), HasSubstr(R"("points":[[-0.5,-1,-1.5])"));
}

TEST(SparkDsg, BoxWithoutMeshAndNothingAtAllSurvive) {
  TemporaryFolder folder;
  SceneGraph graph;
  graph.objects.resize(2);
  graph.objects[0].id = 1;
  graph.objects[0].box = Aabb(Eigen::Vector3d(1, 2, 3), Eigen::Vector3d(2, 4, 6));
  graph.objects[1].id = 2;
  writeSparkDsg(folder / "g.json", graph);
  const SceneGraph read = readSparkDsg(folder / "g.json");
  EXPECT_EQ(read.objects[0].box.min(), Eigen::Vector3d(1, 2, 3));
  EXPECT_EQ(read.objects[0].box.max(), Eigen::Vector3d(2, 4, 6));
  EXPECT_TRUE(read.objects[1].box.isEmpty());
  writeSparkDsg(folder / "empty.json", {});
  EXPECT_TRUE(readSparkDsg(folder / "empty.json").objects.empty());
}

TEST(SparkDsg, WhatJsonCannotSayIsRefusedBeforeWriting) {
  TemporaryFolder folder;
  SceneGraph graph = someGraph();
  graph.objects[1].mesh.vertices[3].y() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THAT(messageOf<InputError>([&] { writeSparkDsg(folder / "g.json", graph); }),
              HasSubstr("g.json: not written: object 5692549928996306945 (object_1) has a mesh "
                        "vertex that is not finite"));
  graph = someGraph();
  graph.objects[1].id = graph.objects[0].id;
  EXPECT_THAT(messageOf<InputError>([&] { writeSparkDsg(folder / "g.json", graph); }),
              HasSubstr("has the id of another object"));
  EXPECT_FALSE(std::filesystem::exists(folder / "g.json"));
}

}  // namespace
}  // namespace hydrabench

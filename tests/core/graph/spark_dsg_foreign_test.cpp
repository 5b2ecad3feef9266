// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include <filesystem>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/graph/spark_dsg_json.h"

namespace hydrabench {
namespace {

using ::testing::ElementsAre;

// The files were written by hand from the format of spark_dsg 1.1.3, never by our own writer.
SceneGraph readSample(const char* name) {
  return readSparkDsg(std::filesystem::path(HYDRABENCH_TEST_DATA_DIR) / "graphs" / name);
}

TEST(KhronosGraph, OnlyObjectsAreTakenFromTheLayers) {
  const SceneGraph graph = readSample("khronos.json");
  ASSERT_EQ(graph.objects.size(), 2u);
  EXPECT_EQ(graph.objects[0].id, objectNodeId(3));
  EXPECT_EQ(graph.objects[1].id, objectNodeId(4));
  EXPECT_TRUE(graph.scene_mesh.vertices.empty());
}

TEST(KhronosGraph, MeshPointsAreRelativeToTheBoxCenter) {
  const ObjectNode object = readSample("khronos.json").objects[0];
  ASSERT_EQ(object.mesh.vertices.size(), 4u);
  EXPECT_EQ(object.mesh.vertices[0], Eigen::Vector3d(0.75, 1.75, 0));
  EXPECT_EQ(object.mesh.vertices[3], Eigen::Vector3d(1, 2, 1));
  EXPECT_THAT(object.mesh.faces, ElementsAre(Eigen::Vector3i(0, 1, 3), Eigen::Vector3i(1, 2, 3)));
  EXPECT_EQ(object.mesh.colors[3], (Rgb{255, 0, 128}));
  EXPECT_EQ(object.box.min(), Eigen::Vector3d(0.75, 1.75, 0));
  EXPECT_EQ(object.box.max(), Eigen::Vector3d(1.25, 2.25, 1));
}

TEST(KhronosGraph, MeshPointsTurnWithATurnedBox) {
  // A quarter turn about z takes (1, 0, 0) to (0, 1, 0) and (0, 2, 0) to (-2, 0, 0).
  const ObjectNode object = readSample("khronos.json").objects[1];
  EXPECT_TRUE(object.mesh.vertices[0].isApprox(Eigen::Vector3d(4, 1, 1)));
  EXPECT_TRUE(object.mesh.vertices[1].isApprox(Eigen::Vector3d(2, 0, 1)));
  EXPECT_EQ(object.mesh.vertices[2], Eigen::Vector3d(4, 0, 1.5));
}

TEST(KhronosGraph, PoseNameLabelAndTimesAreRead) {
  const ObjectNode object = readSample("khronos.json").objects[0];
  EXPECT_EQ(object.name, "seat");
  EXPECT_EQ(object.label, 5);
  EXPECT_EQ(object.scale, 1);
  EXPECT_EQ(object.T_world_object.translation(), Eigen::Vector3d(1, 2, 0.5));
  EXPECT_TRUE((object.T_world_object.linear() * Eigen::Vector3d::UnitX())
                  .isApprox(Eigen::Vector3d::UnitY()));
  EXPECT_EQ(object.first_observed_ns, 9007199254740993);  // has no double
  EXPECT_EQ(object.last_observed_ns, 9007199254741001);
}

TEST(KhronosGraph, TheLargestLabelMeansNone) {
  EXPECT_EQ(readSample("khronos.json").objects[1].label, kUnknownLabel);
}

TEST(KhronosGraph, LabelNamesComeFromTheMetadata) {
  const LabelSpace label_space = readSample("khronos.json").label_space;
  ASSERT_EQ(label_space.entries.size(), 3u);
  EXPECT_EQ(label_space.nameOf(18), "trash bin");
  EXPECT_EQ(label_space.nameOf(4), "label_4");
  EXPECT_TRUE(label_space.find(Label{5})->is_object);
  EXPECT_EQ(label_space.find(Label{5})->color, (Rgb{102, 255, 0}));
  EXPECT_FALSE(label_space.find(Label{19})->is_object);
}

TEST(HydraGraph, ObjectIsTheFacesAllOfWhoseCornersAreListed) {
  const SceneGraph graph = readSample("hydra.json");
  ASSERT_EQ(graph.objects.size(), 3u);
  const ObjectNode& couch = graph.objects[0];
  // Vertices 1..4 are listed: of the four faces, (1, 4, 2) and (2, 4, 3) have no corner at vertex
  // 0.
  EXPECT_EQ(couch.mesh.vertices.size(), 4u) << "vertex 2 is listed twice and counts once";
  EXPECT_EQ(couch.mesh.vertices[0], Eigen::Vector3d(1, 1, 0));
  EXPECT_THAT(couch.mesh.faces, ElementsAre(Eigen::Vector3i(1, 0, 2), Eigen::Vector3i(2, 0, 3)));
  EXPECT_EQ(couch.box.min(), Eigen::Vector3d(0, 0, 0));
  EXPECT_EQ(couch.box.max(), Eigen::Vector3d(1, 1, 1));
  EXPECT_THAT(graph.scene_labels, ElementsAre(3, 7, 7, 7, 7));
  EXPECT_EQ(graph.scene_mesh.faces.size(), 4u);
}

TEST(HydraGraph, ObjectWithoutMeshKeepsItsBox) {
  const ObjectNode plant = readSample("hydra.json").objects[1];
  EXPECT_TRUE(plant.mesh.empty());
  // Turned by a quarter, 2 x 4 x 6 becomes 4 x 2 x 6.
  EXPECT_TRUE(plant.box.min().isApprox(Eigen::Vector3d(8, -1, 0), 1e-12) ||
              (plant.box.min() - Eigen::Vector3d(8, -1, 0)).norm() < 1e-12);
  EXPECT_LT((plant.box.max() - Eigen::Vector3d(12, 1, 6)).norm(), 1e-12);
}

TEST(HydraGraph, InvalidBoxWithoutMeshLeavesAPosition) {
  const ObjectNode object = readSample("hydra.json").objects[2];
  EXPECT_TRUE(object.box.isEmpty());
  EXPECT_EQ(object.T_world_object.translation(), Eigen::Vector3d(7, 8, 9));
}

TEST(HydraGraph, ClassesWithoutNamesStayNameless) {
  EXPECT_EQ(readSample("hydra.json").label_space.nameOf(7), "label_7");
}

}  // namespace
}  // namespace hydrabench

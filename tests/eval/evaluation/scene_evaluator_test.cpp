// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/evaluation/scene_evaluator.h"

#include <cmath>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/types/error.h"

namespace hydrabench {
namespace {

constexpr Label kGrass = 3;
constexpr Label kWall = 5;

LabelSpace labels() {
  LabelSpace space;
  space.entries = {{kGrass, "grass", {}, false, false, true}, {kWall, "wall", {}, false, false}};
  return space;
}

/// A level rectangle that looks up.
Mesh level(double x_low, double x_high, double y_low, double y_high, double z = 0) {
  Mesh mesh;
  mesh.vertices = {{x_low, y_low, z}, {x_high, y_low, z}, {x_high, y_high, z}, {x_low, y_high, z}};
  mesh.faces = {{0, 1, 2}, {0, 2, 3}};
  return mesh;
}

/// Level grass of 100 m x 100 m; a drive of 10 m along x, half a metre above it.
GroundTruth meadow() {
  GroundTruth truth;
  truth.scene_mesh = level(-50, 50, -50, 50);
  truth.scene_labels.assign(2, kGrass);
  for (int i = 0; i <= 100; ++i) {
    StampedPose pose;
    pose.stamp_ns = i;
    pose.T_world_camera.translation() = Eigen::Vector3d(0.1 * i, 0, 0.5);
    truth.trajectory.push_back(pose);
  }
  return truth;
}

void addBox(const Aabb& box, Label label, GroundTruth& truth) {
  append(boxMesh(box), truth.scene_mesh);
  truth.scene_labels.resize(truth.scene_mesh.faces.size(), label);
}

SceneTally scored(const GroundTruth& truth, const SceneGraph& map) {
  SceneScoringConfig config;
  config.points_per_m2 = 100;
  return total(SceneEvaluator(truth, labels(), config).evaluate(map));
}
SceneTally scored(const GroundTruth& truth, const Mesh& mesh) {
  SceneGraph map;
  map.scene_mesh = mesh;
  return scored(truth, map);
}

/// Area within r of a line of 10 m.
double areaWithin(double r) { return 20 * r + M_PI * r * r; }

TEST(SceneEvaluator, FindsNothingMissingInTheTruthItself) {
  const GroundTruth truth = meadow();
  const SceneTally tally = scored(truth, truth.scene_mesh);
  for (int band = 0; band < 3; ++band) EXPECT_EQ(groundCompleteness(tally, band), 1) << band;
  EXPECT_EQ(groundHoleArea(tally), 0);
  EXPECT_EQ(groundRms(tally), 0);
  EXPECT_EQ(tally.boundary_m, 0);  // its edges are farther than 20 m from the path
  EXPECT_EQ(sceneFScore(tally, 0), 1);
  EXPECT_NEAR(tally.ground_m2[0], areaWithin(5), 5);
  EXPECT_NEAR(tally.ground_m2[1], areaWithin(10) - areaWithin(5), 10);
  EXPECT_NEAR(tally.ground_m2[2], areaWithin(20) - areaWithin(10), 20);
}

TEST(SceneEvaluator, CountsAllGroundAsAHoleWithoutAMap) {
  const SceneTally tally = scored(meadow(), Mesh());
  EXPECT_EQ(groundCompleteness(tally), 0);
  EXPECT_NEAR(groundHoleArea(tally), areaWithin(20), 20);
  EXPECT_EQ(sceneFScore(tally, 2), 0);
}

TEST(SceneEvaluator, MeasuresHowFarTheGroundIsOff) {
  const GroundTruth truth = meadow();
  const SceneTally near = scored(truth, level(-50, 50, -50, 50, 0.1));
  EXPECT_NEAR(*groundRms(near), 0.1, 1e-6);
  EXPECT_EQ(groundCompleteness(near), 1);
  EXPECT_EQ(sceneFScore(near, 0), 0);
  EXPECT_EQ(sceneFScore(near, 2), 1);
  EXPECT_EQ(groundCompleteness(scored(truth, level(-50, 50, -50, 50, 0.3))), 0);
}

TEST(SceneEvaluator, MeasuresAHoleAndItsRim) {
  Mesh map = level(-50, 50, -50, -3);
  append(level(-50, 50, -1, 50), map);
  append(level(-50, 0, -3, -1), map);
  append(level(10, 50, -3, -1), map);  // 10 m x 2 m are missing
  const SceneTally tally = scored(meadow(), map);
  EXPECT_NEAR(groundHoleArea(tally), 9.6 * 1.6, 1);  // within 0.2 m of the mesh is covered
  EXPECT_EQ(groundCompleteness(tally, 1), 1);
  EXPECT_GT(tally.boundary_m, 0);
}

TEST(SceneEvaluator, DoesNotAskForWhatAWallHides) {
  GroundTruth truth = meadow();
  addBox(Aabb(Eigen::Vector3d{-40, 4, 0}, Eigen::Vector3d{50, 5, 3}), kWall, truth);
  const SceneTally tally = scored(truth, Mesh());
  EXPECT_NEAR(tally.ground_m2[0] + tally.ground_m2[1] + tally.ground_m2[2],
              areaWithin(20) / 2 + 4 * (10 + 2 * 19.8), 30);
  EXPECT_GT(tally.truth_points, 100u * (200 + 4 * 40));  // the wall itself counts
}

SceneGraph voxels(const std::vector<Eigen::Vector3f>& centers) {
  SceneGraph map;
  map.occupied = centers;
  map.occupied_voxel_m = 0.2;
  return map;
}

TEST(SceneEvaluator, CountsVoxelsThatAreTakenForSolidThoughFree) {
  GroundTruth truth = meadow();
  addBox(Aabb(Eigen::Vector3d{2, 8, 0}, Eigen::Vector3d{3, 9, 1}), kWall, truth);
  const auto filled = [&](const std::vector<Eigen::Vector3f>& centers) {
    return scored(truth, voxels(centers)).filled_m3;
  };
  EXPECT_THAT(filled({{5, 0, -1}, {5, 0, 0.1f}, {2.5f, 8.5f, 0.5f}, {200, 0, 1}}),
              testing::IsEmpty());  // below ground, near it, in the box, far away
  const auto in_the_air = filled({{5, -2, 1.1f}, {5, -2, 1.11f}, {2.5f, 7, 0.7f}});
  EXPECT_NEAR(in_the_air.at("elsewhere"), 0.008, 1e-9);  // once, although listed twice
  EXPECT_NEAR(in_the_air.at("wall"), 0.008, 1e-9);
}

TEST(SceneEvaluator, CallsUprightGroundAKerb) {
  GroundTruth truth = meadow();
  addBox(Aabb(Eigen::Vector3d{-50, 3, -1}, Eigen::Vector3d{50, 50, 0.15}), kGrass,
         truth);  // a pavement
  const auto filled = scored(truth, voxels({{5, 2, 0.5f}, {5, -5, 0.5f}})).filled_m3;
  EXPECT_NEAR(filled.at("kerb"), 0.008, 1e-9);
  EXPECT_NEAR(filled.at("elsewhere"), 0.008, 1e-9);
}

std::string faultOf(const GroundTruth& truth, const SceneScoringConfig& config = {}) {
  try {
    const SceneEvaluator evaluator(truth, labels(), config);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(SceneEvaluator, SaysWhatTheGroundTruthLacks) {
  GroundTruth truth = meadow();
  truth.scene_labels.clear();
  EXPECT_THAT(faultOf(truth), testing::HasSubstr("0 labels for the 2 faces"));
  truth = meadow();
  truth.trajectory.clear();
  EXPECT_THAT(faultOf(truth), testing::HasSubstr("no scene mesh or no path"));
  SceneScoringConfig config;
  config.ground = {"gras"};
  EXPECT_THAT(faultOf(meadow(), config), testing::HasSubstr("evaluation.scene.ground is [gras]"));
}

}  // namespace
}  // namespace hydrabench

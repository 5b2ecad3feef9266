// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/evaluation/damage.h"

#include <cmath>
#include <set>

#include <gtest/gtest.h>

#include "eval/evaluation/order_check.h"
#include "eval/oracles/ground_truth_prediction.h"
#include "tests/eval/evaluation/scattered_world.h"

namespace hydrabench {
namespace {

/// Three chairs at x = 0, 1 and 5, a bin at 9.
Prediction fourObjects() {
  GroundTruth truth;
  truth.objects = {
      standingBox(0, kChair, 0, 0, {0.5, 0.5, 1}), standingBox(1, kChair, 1, 0, {0.5, 0.5, 2}),
      standingBox(2, kChair, 5, 0, {0.5, 0.5, 1}), standingBox(3, kBin, 9, 0, {0.5, 0.5, 1})};
  return groundTruthPrediction(furnitureLabels(), truth);
}

/// What is claimed of the centres is so.
void expectCentersAsClaimed(const DamagedPrediction& damaged) {
  ASSERT_EQ(damaged.estimates.size(), damaged.prediction.graph.objects.size());
  for (std::size_t i = 0; i < damaged.estimates.size(); ++i) {
    const ObjectNode& node = damaged.prediction.graph.objects[i];
    EXPECT_EQ(damaged.estimates[i].id, node.id);
    EXPECT_EQ(damaged.estimates[i].label, node.label);
    EXPECT_LT((damaged.estimates[i].center - bounds(node.mesh).center()).norm(), 1e-12);
    EXPECT_TRUE(node.box.isApprox(bounds(node.mesh)));
  }
}

TEST(Damage, MergesTheTwoClosestOfAClass) {
  const MergedPrediction damaged = merged(fourObjects());
  expectCentersAsClaimed(damaged);
  ASSERT_EQ(damaged.estimates.size(), 3u);
  // Together they reach from -0.25 to 1.25 and up to 2.
  EXPECT_EQ(damaged.estimates[0].center, Eigen::Vector3d(0.5, 0, 1));
  ASSERT_EQ(damaged.joins.size(), 1u);
  EXPECT_EQ(damaged.joins[0].node, 0u);
  EXPECT_EQ(damaged.joins[0].parts[1].center, Eigen::Vector3d(1, 0, 1));
}

TEST(Damage, ListsEverythingTwiceUnderDifferentIds) {
  const DamagedPrediction damaged = doubled(fourObjects());
  expectCentersAsClaimed(damaged);
  std::set<ObjectId> ids;
  for (const ObjectNode& node : damaged.prediction.graph.objects) ids.insert(node.id);
  EXPECT_EQ(ids.size(), 8u);
}

TEST(Damage, ChangesCoordinatesOfCentresAndMeshesAlike) {
  Eigen::Matrix3d mirrored;
  mirrored << 0, 1000, 0, 1000, 0, 0, 0, 0, 1000;
  const DamagedPrediction damaged = changed(fourObjects(), {mirrored, {7, 8, 9}});
  expectCentersAsClaimed(damaged);
  EXPECT_EQ(damaged.estimates[2].center, Eigen::Vector3d(7, 5008, 509));
  EXPECT_LT(signedVolume(damaged.prediction.graph.objects[0].mesh), 0) << "a mirror";
}

TEST(Damage, TurnsMeshesInsideOutWithoutMovingThem) {
  const DamagedPrediction damaged = turnedInsideOut(fourObjects());
  expectCentersAsClaimed(damaged);
  EXPECT_DOUBLE_EQ(signedVolume(damaged.prediction.graph.objects[0].mesh), -0.25);
}

TEST(Damage, PutsOneNotANumberWhereItWasTold) {
  const Prediction damaged = withNan(fourObjects(), 2);
  for (std::size_t i = 0; i < 4; ++i) {
    std::size_t bad = 0;
    for (const Eigen::Vector3d& v : damaged.graph.objects[i].mesh.vertices) bad += !v.allFinite();
    EXPECT_EQ(bad, i == 2 ? 1u : 0u);
  }
}

TEST(Shuffle, ChangesOrderAndIdsButNotTheObjects) {
  const Prediction before = fourObjects();
  std::set<std::vector<std::string>> orders;
  for (std::uint64_t stream = 0; stream < 20; ++stream) {
    Prediction after = before;
    shuffle(after, 1, stream);
    std::vector<std::string> names;
    std::set<ObjectId> ids;
    for (const ObjectNode& node : after.graph.objects) {
      names.push_back(node.name);
      ids.insert(node.id);
    }
    EXPECT_EQ(ids.size(), 4u);
    orders.insert(names);
    std::sort(names.begin(), names.end());
    EXPECT_EQ(names, (std::vector<std::string>{"object_0", "object_1", "object_2", "object_3"}));
  }
  EXPECT_GT(orders.size(), 5u);
}

TEST(Shuffles, ChangeNothing) {
  std::string fault = "not called";
  EvaluationConfig config;
  checkShuffles("scattered", "1", furnitureLabels(), scatteredWorld(), config, 5,
                [&](const std::string&, const std::string& wrong, const std::string& seen) {
                  fault = wrong;
                  EXPECT_EQ(seen, "5 shuffles of 32 boxes, 50 samples, 20 resamples");
                });
  EXPECT_EQ(fault, "");
}

}  // namespace
}  // namespace hydrabench

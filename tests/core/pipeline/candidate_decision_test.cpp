// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "core/pipeline/candidate_decision.h"

#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/graph/spark_dsg_json.h"

namespace hydrabench {
namespace {

using Eigen::Vector3d;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

/// A cube around (x, 0, 0).
Mesh cube(double x, double side) {
  const Vector3d half = Vector3d::Constant(0.5 * side);
  return boxMesh(Aabb(Vector3d(x, 0, 0) - half, Vector3d(x, 0, 0) + half));
}

ShapeCandidate candidate(double x, double side, double overlap = 0.9, double volume = 1) {
  ShapeCandidate result;
  result.label = 5;
  result.mesh = cube(x, side);
  result.box = bounds(result.mesh);
  result.T_world_object.translation() = Vector3d(x, 0, 0);
  result.scale = 0.5 * side;
  result.overlap = overlap;
  result.coverage = 0.9;
  result.depth_residual_m = 0.01;
  result.view_volume_m3 = volume;
  return result;
}

std::vector<std::size_t> kept(const std::vector<ShapeCandidate>& candidates,
                              const DecisionConfig& config = {}) {
  std::vector<std::size_t> indices;
  for (const auto& object : decide(candidates, config).objects) indices.push_back(object.candidate);
  return indices;
}

TEST(Decision, KeepsWhatIsAboveTheThreshold) {
  const std::vector<ShapeCandidate> candidates = {candidate(0, 1, 0.21), candidate(5, 1, 0.22),
                                                  candidate(9, 1, 1.0)};
  EXPECT_THAT(kept(candidates), ElementsAre(1, 2));
  DecisionConfig config;
  config.rmcc.min_overlap = 0;
  EXPECT_THAT(kept(candidates, config), ElementsAre(0, 1, 2));
  config.rmcc.min_overlap = 1;
  EXPECT_THAT(kept(candidates, config), IsEmpty());
  config.rmcc.check = "none";
  EXPECT_THAT(kept(candidates, config), ElementsAre(0, 1, 2));
}

TEST(Decision, SaysWhyACandidateIsRejected) {
  std::vector<ShapeCandidate> candidates = {candidate(0, 1, 0.1), candidate(5, 1), candidate(9, 1),
                                            candidate(13, 1)};
  candidates[1].coverage = 0.2;
  candidates[2].depth_residual_m = 0.5;
  candidates[3].failure = "too few points";
  DecisionConfig config;
  config.rmcc.check = "extended";
  const Decision decision = decide(candidates, config);
  std::vector<std::string> reasons;
  for (const auto& verdict : decision.verdicts) {
    EXPECT_FALSE(verdict.accepted);
    EXPECT_EQ(verdict.object, -1);
    reasons.push_back(verdict.reason);
  }
  EXPECT_THAT(reasons,
              ElementsAre("overlap", "coverage", "depth_residual", "failure: too few points"));
  EXPECT_THAT(decision.objects, IsEmpty());
}

TEST(Decision, MergesWhereABoxContainsTheOthersCentre) {
  // Cubes of 1 m: at 0.5 m the centre lies on the border, at 0.6 m outside both boxes.
  EXPECT_THAT(kept({candidate(0, 1), candidate(0.5, 1)}), ElementsAre(0));
  EXPECT_THAT(kept({candidate(0, 1), candidate(0.6, 1)}), ElementsAre(0, 1));
  // One of them is enough.
  EXPECT_THAT(kept({candidate(0, 0.2), candidate(0.6, 2)}), ElementsAre(0));
  std::vector<ShapeCandidate> two_classes = {candidate(0, 1), candidate(0, 1)};
  two_classes[1].label = 7;
  EXPECT_THAT(kept(two_classes), ElementsAre(0, 1));
  DecisionConfig apart;
  apart.merge_revisited = false;
  EXPECT_THAT(kept({candidate(0, 1), candidate(0, 1)}, apart), ElementsAre(0, 1));
}

TEST(Decision, KeepsTheShapeWithMoreEvidence) {
  const std::vector<ShapeCandidate> candidates = {
      candidate(0, 1, 0.9, 1), candidate(0.1, 1, 0.5, 2), candidate(0.2, 1, 0.7, 2)};
  EXPECT_THAT(kept(candidates), ElementsAre(1));
  DecisionConfig config;
  config.merge_evidence = "overlap";
  EXPECT_THAT(kept(candidates, config), ElementsAre(0));
}

TEST(Decision, AMergedObjectLivesFromTheFirstObservationToTheLast) {
  std::vector<ShapeCandidate> candidates = {candidate(9, 1), candidate(0, 1, 0.9, 1),
                                            candidate(0.1, 1, 0.9, 2)};
  candidates[1].first_observed_ns = 10;
  candidates[1].last_observed_ns = 20;
  candidates[2].first_observed_ns = 50;
  candidates[2].last_observed_ns = 60;
  const Decision decision = decide(candidates, {});
  ASSERT_EQ(decision.objects.size(), 2u);
  EXPECT_EQ(decision.objects[1].candidate, 2u);
  EXPECT_EQ(decision.objects[1].first_observed_ns, 10);
  EXPECT_EQ(decision.objects[1].last_observed_ns, 60);
  EXPECT_EQ(decision.verdicts[1].object, 1);
  EXPECT_EQ(decision.verdicts[2].object, 1);
  record(decision, candidates);
  EXPECT_EQ(candidates[1].object, objectNodeId(1));
  EXPECT_TRUE(candidates[1].accepted);
}

TEST(Decision, AMergedShapeMayReachAThirdOne) {
  // 0 and 1 are apart; 2 is both.
  EXPECT_THAT(kept({candidate(0, 1), candidate(1.4, 1), candidate(0.7, 1.6, 0.9, 3)}),
              ElementsAre(2));
}

TEST(Decision, RejectedTracksLeaveTheirPartialMeshWhereAskedTo) {
  std::vector<ShapeCandidate> candidates = {candidate(0, 1, 0.1), candidate(5, 1, 0.1),
                                            candidate(0.1, 1, 0.9, 0.5)};
  candidates[0].partial_mesh = cube(0, 0.5);
  EXPECT_THAT(kept(candidates), ElementsAre(2));
  DecisionConfig config;
  config.rejected = "partial_mesh";
  EXPECT_THAT(kept(candidates, config), ElementsAre(2));  // the shape wins, volume or not
  config.merge_revisited = false;
  const Decision decision = decide(candidates, config);
  ASSERT_EQ(decision.objects.size(), 2u);
  EXPECT_TRUE(decision.objects[0].partial);
  EXPECT_FALSE(decision.verdicts[0].accepted);
  EXPECT_EQ(decision.verdicts[0].object, 0);
  const auto nodes = objectNodes(candidates, decision, {});
  EXPECT_EQ(nodes[0].mesh.vertices, candidates[0].partial_mesh.vertices);
  EXPECT_EQ(nodes[0].scale, 1);
  EXPECT_EQ(nodes[1].mesh.vertices, candidates[2].mesh.vertices);
  EXPECT_EQ(nodes[1].scale, 0.5);
  EXPECT_EQ(nodes[1].T_world_object.translation(), Vector3d(0.1, 0, 0));
}

}  // namespace
}  // namespace hydrabench

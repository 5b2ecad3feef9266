// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "metrics/detection.h"

#include <gtest/gtest.h>

namespace hydrabench {
namespace {

TEST(DetectionScores, AreTheHandWorkedFractions) {
  const DetectionCounts counts{8, 6, 5, 2};
  EXPECT_DOUBLE_EQ(*precision(counts), 6.0 / 8);
  EXPECT_DOUBLE_EQ(*recall(counts), 2.0 / 5);
  EXPECT_DOUBLE_EQ(*f1(counts), 2 * 0.75 * 0.4 / 1.15);
}

TEST(DetectionScores, EverythingFoundScoresOne) {
  const DetectionCounts counts{3, 3, 3, 3};
  EXPECT_EQ(precision(counts), 1.0);
  EXPECT_EQ(recall(counts), 1.0);
  EXPECT_EQ(f1(counts), 1.0);
}

TEST(DetectionScores, NothingFoundScoresZero) {
  const DetectionCounts counts{3, 0, 4, 0};
  EXPECT_EQ(precision(counts), 0.0);
  EXPECT_EQ(recall(counts), 0.0);
  EXPECT_EQ(f1(counts), 0.0);
}

TEST(DetectionScores, EmptyEstimatesLeavePrecisionUndefinedAndScoreZero) {
  const DetectionCounts counts{0, 0, 4, 0};
  EXPECT_EQ(precision(counts), std::nullopt);
  EXPECT_EQ(recall(counts), 0.0);
  EXPECT_EQ(f1(counts), 0.0);
}

TEST(DetectionScores, EmptyTruthLeavesRecallUndefinedAndScoresZero) {
  const DetectionCounts counts{4, 0, 0, 0};
  EXPECT_EQ(precision(counts), 0.0);
  EXPECT_EQ(recall(counts), std::nullopt);
  EXPECT_EQ(f1(counts), 0.0);
}

TEST(DetectionScores, BothEmptyIsUndefined) {
  const DetectionCounts counts{};
  EXPECT_EQ(precision(counts), std::nullopt);
  EXPECT_EQ(recall(counts), std::nullopt);
  EXPECT_EQ(f1(counts), std::nullopt);
}

TEST(DetectionScores, CountsAddUpBeforeTheyAreDivided) {
  DetectionCounts pooled{1, 1, 1, 1};
  pooled += {9, 0, 3, 0};
  EXPECT_EQ(pooled, (DetectionCounts{10, 1, 4, 1}));
  EXPECT_DOUBLE_EQ(*precision(pooled), 1.0 / 10);  // the mean of 1 and 0 would be 1/2
}

TEST(Threshold, IsStrict) {
  const DetectionObject truth{1, 1, {0, 0, 0}, 0.25};
  EXPECT_TRUE(Threshold::tau(0.5).admits(0.4999999, truth));
  EXPECT_FALSE(Threshold::tau(0.5).admits(0.5, truth));
  EXPECT_FALSE(Threshold::kappa(2).admits(0.5, truth));
  EXPECT_TRUE(Threshold::kappa(2).admits(0.4999999, truth));
}

TEST(Threshold, KappaScalesWithTheTruth) {
  const DetectionObject bin{1, 1, {0, 0, 0}, 0.25};
  const DetectionObject couch{2, 1, {0, 0, 0}, 1.0};
  EXPECT_DOUBLE_EQ(Threshold::kappa(0.5).gate(bin), 0.125);
  EXPECT_DOUBLE_EQ(Threshold::kappa(0.5).gate(couch), 0.5);
  EXPECT_DOUBLE_EQ(Threshold::tau(0.2).gate(couch), 0.2);
}

TEST(Threshold, ATruthWithoutExtentIsNeverMatchedUnderKappa) {
  const DetectionObject point{1, 1, {0, 0, 0}, 0};
  EXPECT_FALSE(Threshold::kappa(100).admits(0, point));
  EXPECT_TRUE(Threshold::tau(0.1).admits(0, point));
}

TEST(DetectionObject, CentreIsOfTheBoxAndNotTheMeanOfTheVertices) {
  Mesh mesh = boxMesh(Aabb(Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(2, 2, 1)));
  const int corner = mesh.faces[0][0];
  for (int i = 0; i < 20; ++i) {  // a mesh that is dense in one corner
    mesh.vertices.push_back(mesh.vertices[static_cast<std::size_t>(corner)]);
    mesh.faces.emplace_back(corner, corner, static_cast<int>(mesh.vertices.size()) - 1);
  }
  const DetectionObject object = detectionObject(7, 3, mesh);
  EXPECT_EQ(object.id, 7u);
  EXPECT_EQ(object.label, 3);
  EXPECT_TRUE(object.center.isApprox(Eigen::Vector3d(1, 1, 0.5)));
  EXPECT_DOUBLE_EQ(object.half_diagonal, 1.5);
}

TEST(DetectionObject, StrayVerticesBelongToNoObject) {
  Mesh mesh = boxMesh(Aabb(Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(1, 1, 1)));
  mesh.vertices.emplace_back(100, 0, 0);
  EXPECT_TRUE(detectionObject(1, 1, mesh).center.isApprox(Eigen::Vector3d(0.5, 0.5, 0.5)));
}

}  // namespace
}  // namespace hydrabench

// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "metrics/pair_scores.h"

#include <gtest/gtest.h>

#include "tests/metrics/shapes.h"

namespace hydrabench {
namespace {

using Role = ObjectModel::Role;

ObjectModel model(const Mesh& mesh, Role role) {
  ObjectModel::Config config;
  config.samples = 2000;
  return ObjectModel(mesh, role, config);
}
PairScores scored(const Mesh& estimate, const Mesh& truth) {
  return scorePair(model(estimate, Role::kEstimate), model(truth, Role::kTruth));
}

TEST(PairScores, UnitCubesShiftedByAMultipleOfThePitchHaveTheClosedForm) {
  for (const double d : {0.05, 0.25, 0.5, 0.75}) {
    const PairScores scores = scored(unitCube(d), unitCube());
    const double expected = (1 - d) / (1 + d);
    EXPECT_NEAR(*scores.b_iou, expected, 1e-12);
    EXPECT_NEAR(*scores.obb_iou, expected, 1e-6);
    EXPECT_NEAR(*scores.v_iou_solid, expected, 1e-12);
    EXPECT_NEAR(*scores.v_iou_solid_jitter_mean, expected, 1e-12);
    EXPECT_NEAR(*scores.v_iou_solid_jitter_std, 0, 1e-12);
  }
}

TEST(PairScores, GroundTruthAgainstItselfIsPerfectWatertightOrOpen) {
  const Mesh closed = potato({4.2, 1.3, 0.6}, 0.5, 3);
  const Mesh open = without(closed, [](const Eigen::Vector3d& c) { return c.z() > 0.85; });
  for (const Mesh& mesh : {closed, open, unitCube(), openTopCube()}) {
    const PairScores scores = scored(mesh, mesh);
    for (const PairScoreColumn& column : pairScoreColumns()) {
      if (column.name == "chamfer_sq" || column.direction == ScoreDirection::kReference) continue;
      const double perfect = column.direction == ScoreDirection::kHigherIsBetter ? 1 : 0;
      EXPECT_EQ(scores.*column.value, perfect) << column.name;
    }
    EXPECT_NEAR(*scores.chamfer_sq, *scores.chamfer_sq_floor, 0.2 * *scores.chamfer_sq_floor);
  }
}

TEST(PairScores, OrientedBoxesDoNotChangeUnderRotationAlignedOnesDo) {
  const Mesh board = cuboid({0, 0, 0}, {1, 0.05, 0.6});
  const Mesh beside = moved(board, {0, 0.06, 0});
  const Transform turn(Eigen::AngleAxisd(0.6, Eigen::Vector3d::UnitZ()));
  EXPECT_EQ(scored(beside, board).b_iou, 0.0);
  const PairScores turned = scored(transformed(turn, beside), transformed(turn, board));
  EXPECT_GT(*turned.b_iou, 0.5);
  EXPECT_NEAR(*turned.obb_iou, 0, 1e-9);
}

TEST(PairScores, PercentThresholdsScaleWithTheTruth) {
  // Cubes moved by 1 cm: within 2 cm at any size, within 1 % of the diagonal from 0.58 m on.
  for (const double scale : {0.5, 0.7}) {
    const Mesh truth = scaled(scale, unitCube());
    const PairScores scores = scored(moved(truth, {0.01, 0, 0}), truth);
    EXPECT_EQ(scores.f_score_2cm, 1.0);
    const double percent = 0.01 * scale * std::sqrt(3.0);
    EXPECT_EQ(*scores.f_score_1pct == 1.0, percent > 0.01);
  }
}

TEST(PairScores, AnEstimateWithoutASurfaceScoresZeroAndHasNoDistances) {
  const PairScores scores = scored(Mesh(), unitCube());
  for (const PairScoreColumn& column : pairScoreColumns()) {
    if (column.direction == ScoreDirection::kHigherIsBetter) {
      EXPECT_EQ(scores.*column.value, 0.0) << column.name;
    }
    if (column.direction == ScoreDirection::kLowerIsBetter) {
      EXPECT_EQ(scores.*column.value, std::nullopt) << column.name;
    }
  }
}

TEST(PairScores, ATruthWithoutASurfaceLeavesAllUndefined) {
  EXPECT_EQ(scored(unitCube(), Mesh()), PairScores{});
}

TEST(PairScores, OpenSheetsHaveNoSolidToCompare) {
  Mesh sheet;
  sheet.vertices = {{0, 0, 0.01}, {1, 0, 0.01}, {1, 1, 0.01}, {0, 1, 0.01}};
  sheet.faces = {{0, 1, 2}, {0, 2, 3}};
  const PairScores scores = scored(sheet, sheet);
  EXPECT_EQ(scores.v_iou_solid, std::nullopt);
  EXPECT_EQ(scores.v_iou_surface, 1.0);
  EXPECT_EQ(scores.accuracy, 0.0);
}

TEST(PairScores, AreEqualForEqualInput) {
  const Mesh estimate = potato({0, 0, 0}, 0.4, 3, 1), truth = potato({0, 0, 0.05}, 0.4, 3);
  EXPECT_EQ(scored(estimate, truth), scored(estimate, truth));
}

TEST(PairScoreColumns, NameEveryFieldOnce) {
  PairScores scores;
  for (const PairScoreColumn& column : pairScoreColumns()) {
    EXPECT_EQ(scores.*column.value, std::nullopt) << column.name << " shares a field";
    scores.*column.value = 1;
    EXPECT_EQ(findPairScoreColumn(column.name), &column);
  }
  EXPECT_EQ(sizeof(PairScores), pairScoreColumns().size() * sizeof(std::optional<double>))
      << "a field has no column";
  EXPECT_EQ(findPairScoreColumn("no_such_score"), nullptr);
}

TEST(PairScoreColumns, AMissScoresTheWorstValue) {
  EXPECT_EQ(findPairScoreColumn("v_iou_solid")->worst(0.5), 0.0);
  EXPECT_EQ(findPairScoreColumn("f_score_1pct")->worst(0.5), 0.0);
  EXPECT_EQ(findPairScoreColumn("chamfer_l1")->worst(0.5), 1.0);
  EXPECT_EQ(findPairScoreColumn("completeness")->worst(2), 4.0);
  EXPECT_EQ(findPairScoreColumn("chamfer_sq")->worst(0.5), 2.0);
  EXPECT_EQ(findPairScoreColumn("chamfer_sq_floor")->worst(0.5), std::nullopt);
}

}  // namespace
}  // namespace hydrabench

// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "metrics/aggregate.h"

#include <gtest/gtest.h>

namespace hydrabench {
namespace {

PairScores withIou(std::optional<double> v_iou, std::optional<double> chamfer_l1 = 0.1) {
  PairScores scores;
  scores.v_iou_solid = v_iou;
  scores.chamfer_l1 = chamfer_l1;
  return scores;
}
const PairScoreColumn& kIou = *findPairScoreColumn("v_iou_solid");
const PairScoreColumn& kChamfer = *findPairScoreColumn("chamfer_l1");

/// Class 1: found with 0.9, found with 0.5, missed. Class 2: missed. Class 3: found with 0.4,
/// d_diag 0.5.
const std::vector<TruthOutcome> kTruths = {{1, 1.0, true, withIou(0.9)},
                                           {1, 1.0, true, withIou(0.5)},
                                           {1, 1.0, true, std::nullopt},
                                           {2, 2.0, true, std::nullopt},
                                           {3, 0.5, true, withIou(0.4, 7.0)}};
const std::vector<PairOutcome> kPairs = {
    {1, withIou(0.9)}, {1, withIou(0.5)}, {3, withIou(0.4, 7.0)}};

TEST(MeanOverPairs, IsThePapersAndRewardsMissingHardObjects) {
  const ValuesByClass values = valuesOverPairs(kPairs, kTruths, kIou);
  const Mean micro = mean(values, Averaging::kMicro);
  EXPECT_DOUBLE_EQ(*micro.value, (0.9 + 0.5 + 0.4) / 3);
  EXPECT_EQ(micro.n, 3u);
  EXPECT_EQ(micro.undefined, 0u);
}

TEST(MeanOverPairs, MacroLeavesOutAClassWithoutPairsAndCountsIt) {
  const Mean macro = mean(valuesOverPairs(kPairs, kTruths, kIou), Averaging::kMacro);
  EXPECT_DOUBLE_EQ(*macro.value, (0.7 + 0.4) / 2);
  EXPECT_EQ(macro.n, 2u);
  EXPECT_EQ(macro.undefined, 1u);
}

TEST(MeanOverTruths, CountsAMissWithTheWorstValue) {
  const ValuesByClass iou = valuesOverTruths(kTruths, kIou);
  EXPECT_DOUBLE_EQ(*mean(iou, Averaging::kMicro).value, (0.9 + 0.5 + 0 + 0 + 0.4) / 5);
  EXPECT_DOUBLE_EQ(*mean(iou, Averaging::kMacro).value, (1.4 / 3 + 0 + 0.4) / 3);
  EXPECT_EQ(mean(iou, Averaging::kMicro).n, 5u);
}

TEST(MeanOverTruths, CapsDistancesAtTheWholeDiagonal) {
  // Misses: 2 * 1 and 2 * 2; found at 0.1, 0.1 and at 7, which is capped at 2 * 0.5.
  const Mean micro = mean(valuesOverTruths(kTruths, kChamfer), Averaging::kMicro);
  EXPECT_DOUBLE_EQ(*micro.value, (0.1 + 0.1 + 2 + 4 + 1) / 5);
}

TEST(MeanOverTruths, AnUndefinedScoreOfAFoundObjectIsItsWorst) {
  const std::vector<TruthOutcome> truths = {{1, 1.5, true, withIou(std::nullopt, std::nullopt)}};
  EXPECT_EQ(mean(valuesOverTruths(truths, kIou), Averaging::kMicro).value, 0.0);
  EXPECT_EQ(mean(valuesOverTruths(truths, kChamfer), Averaging::kMicro).value, 3.0);
}

TEST(MeanOverTruths, ATruthWithoutASurfaceIsUndefinedAndCounted) {
  const std::vector<TruthOutcome> truths = {{1, 1, false, std::nullopt},
                                            {1, 1, true, withIou(0.5)}};
  const Mean micro = mean(valuesOverTruths(truths, kIou), Averaging::kMicro);
  EXPECT_EQ(micro.value, 0.5);
  EXPECT_EQ(micro.n, 1u);
  EXPECT_EQ(micro.undefined, 1u);
}

TEST(MeanOverTruths, HasNoWorstForReferences) {
  const Mean mean_floor =
      mean(valuesOverTruths(kTruths, *findPairScoreColumn("chamfer_sq_floor")), Averaging::kMicro);
  EXPECT_EQ(mean_floor.value, std::nullopt);
  EXPECT_EQ(mean_floor.undefined, 5u);
}

TEST(Mean, OfNothingIsUndefined) {
  for (const Averaging averaging : {Averaging::kMicro, Averaging::kMacro}) {
    EXPECT_EQ(mean(ValuesByClass{}, averaging).value, std::nullopt);
    const Mean empty_class = mean(valuesOverPairs({}, kTruths, kIou), averaging);
    EXPECT_EQ(empty_class.value, std::nullopt);
    EXPECT_EQ(empty_class.n, 0u);
  }
}

TEST(Mean, DoesNotDependOnTheOrderOfTheInput) {
  std::vector<TruthOutcome> truths;
  for (int i = 0; i < 101; ++i) {
    truths.push_back({i % 3, 1, true, withIou(1.0 / (i + 1), 0.1 / (i + 3))});
  }
  const Mean expected = mean(valuesOverTruths(truths, kIou), Averaging::kMicro);
  for (std::size_t shift = 1; shift < truths.size(); ++shift) {
    std::rotate(truths.begin(), truths.begin() + 37, truths.end());
    ASSERT_EQ(mean(valuesOverTruths(truths, kIou), Averaging::kMicro).value, expected.value);
  }
}

TEST(DetectionAverages, MicroPoolsMacroAveragesClassesWithGroundTruth) {
  // Class 9 has estimates but no ground truth: false positives of the pool, no class of its own.
  const CountsByClass classes = {{1, {2, 2, 4, 2}}, {2, {4, 1, 1, 1}}, {9, {4, 0, 0, 0}}};
  EXPECT_DOUBLE_EQ(*score(classes, precision, Averaging::kMicro).value, 3.0 / 10);
  EXPECT_DOUBLE_EQ(*score(classes, recall, Averaging::kMicro).value, 3.0 / 5);
  EXPECT_DOUBLE_EQ(*score(classes, f1, Averaging::kMicro).value, 2 * 0.3 * 0.6 / 0.9);
  EXPECT_DOUBLE_EQ(*score(classes, precision, Averaging::kMacro).value, (1 + 0.25) / 2);
  EXPECT_DOUBLE_EQ(*score(classes, recall, Averaging::kMacro).value, (0.5 + 1) / 2);
  EXPECT_DOUBLE_EQ(*score(classes, f1, Averaging::kMacro).value, (2.0 / 3 + 0.4) / 2);
  EXPECT_EQ(score(classes, precision, Averaging::kMicro).n, 10u);
  EXPECT_EQ(score(classes, recall, Averaging::kMicro).n, 5u);
  EXPECT_EQ(score(classes, f1, Averaging::kMacro).n, 2u);
}

TEST(DetectionAverages, AClassWithoutEstimatesIsLeftOutOfMacroPrecisionOnly) {
  const CountsByClass classes = {{1, {2, 1, 2, 1}}, {2, {0, 0, 3, 0}}};
  const Mean p = score(classes, precision, Averaging::kMacro);
  EXPECT_EQ(p.value, 0.5);
  EXPECT_EQ(p.n, 1u);
  EXPECT_EQ(p.undefined, 1u);
  EXPECT_EQ(score(classes, recall, Averaging::kMacro).value, 0.25);
  EXPECT_EQ(score(classes, f1, Averaging::kMacro).value, 0.25);
}

}  // namespace
}  // namespace hydrabench

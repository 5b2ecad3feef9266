// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/report/significance.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace hydrabench {
namespace {

using ::testing::HasSubstr;
using ::testing::SizeIs;

constexpr std::size_t kTruths = 40;

ScoredObject object(std::size_t i) {
  ScoredObject result;
  result.detection = {i + 1, 5, {2.0 * static_cast<double>(i), 0, 0}, 0.5};
  result.class_name = "chair";
  result.has_surface = true;
  return result;
}

/// Forty chairs, the later the more of it was seen; the method finds those from `first` on.
MethodEvaluation finder(const std::string& method, std::size_t first, double b_iou = 0.8) {
  MethodEvaluation evaluation;
  evaluation.dataset = "office";
  evaluation.seed = "1";
  evaluation.method = method;
  for (std::size_t i = 0; i < kTruths; ++i) {
    evaluation.truths.push_back(object(i));
    evaluation.truths.back().visible_fraction = (static_cast<double>(i) + 0.5) / kTruths;
    if (i < first) continue;
    PairScores scores;
    scores.b_iou = b_iou;
    scores.v_iou_solid = 0.5;
    scores.chamfer_l1 = 0.02;
    evaluation.pair_scores[{evaluation.estimates.size(), i}] = scores;
    evaluation.estimates.push_back(object(i));
  }
  return evaluation;
}

EvaluationConfig config() {
  EvaluationConfig result;
  result.thresholds_m = {0.2};
  result.bootstrap_resamples = 500;
  return result;
}

TEST(PairedDifferences, ComparesEveryPairTheBetterFirst) {
  const auto all =
      pairedDifferences({finder("blind", 30), finder("keen", 0), finder("fair", 10)}, config());
  ASSERT_THAT(all, SizeIs(12));  // three pairs, four metrics
  EXPECT_EQ(all[0].metric, "f1");
  EXPECT_EQ(all[0].method_a, "keen");
  EXPECT_EQ(all[0].method_b, "fair");
  EXPECT_DOUBLE_EQ(all[0].value_a, 1);
  EXPECT_DOUBLE_EQ(all[0].value_b, 2 * 0.75 / 1.75);
  EXPECT_DOUBLE_EQ(all[0].comparison.difference, 1 - 2 * 0.75 / 1.75);
  EXPECT_GT(all[0].comparison.interval.low, 0);
  EXPECT_LT(all[0].comparison.p_value, 0.01);
  EXPECT_GE(all[0].p_holm, all[0].comparison.p_value);
  EXPECT_EQ(all[0].above, 1);
}

TEST(PairedDifferences, MeansRunOverAllGroundTruthSoAMissCounts) {
  const auto all = pairedDifferences({finder("keen", 0), finder("half", 20)}, config());
  ASSERT_THAT(all, SizeIs(4));
  EXPECT_EQ(all[1].metric, "b_iou_all_gt");
  EXPECT_NEAR(all[1].value_a, 0.8, 1e-12);
  EXPECT_NEAR(all[1].value_b, 0.4, 1e-12);
  EXPECT_EQ(all[3].metric, "chamfer_l1_all_gt");
  EXPECT_NEAR(all[3].value_b, (0.02 + 1.0) / 2, 1e-12);  // the worst is the whole diagonal
}

TEST(PairedDifferences, BetweenEqualMethodsAreNoneAndNotSure) {
  const auto all = pairedDifferences({finder("a", 10), finder("b", 10)}, config());
  EXPECT_EQ(all[0].comparison.difference, 0);
  EXPECT_EQ(all[0].comparison.interval, (Interval{0, 0}));
  EXPECT_EQ(all[0].p_holm, 1);
  EXPECT_NEAR(*all[0].above, 0.5, 0.05);
}

TEST(PairedDifferences, LeaveOutAMethodThatSawOtherTruths) {
  MethodEvaluation other = finder("other", 0);
  other.truths.pop_back();
  other.pair_scores.erase({kTruths - 1, kTruths - 1});
  other.estimates.pop_back();
  EXPECT_THAT(pairedDifferences({finder("a", 10), other}, config()), SizeIs(0));
}

TEST(Significance, PrintsEachMethodAgainstTheNext) {
  const std::string text = significanceMarkdown(
      pairedDifferences({finder("blind", 30), finder("keen", 0), finder("fair", 10)}, config()));
  EXPECT_THAT(text, HasSubstr("### office, tau_d = 0.2 m, one_to_one"));
  EXPECT_THAT(text, HasSubstr("| keen | 1.000 | fair | 0.143 ["));
  EXPECT_THAT(text, HasSubstr("| fair | 0.857 | blind | "));
  EXPECT_THAT(text, ::testing::Not(HasSubstr("| keen | 1.000 | blind")));
}

TEST(RankStability, HasARowForEveryMethodButTheLast) {
  const auto rows = rankStabilityRows(
      pairedDifferences({finder("blind", 30), finder("keen", 0), finder("fair", 10)}, config()));
  ASSERT_THAT(rows, SizeIs(2));
  EXPECT_EQ(rows[0].method, "keen");
  EXPECT_EQ(rows[0].metric, "rank_stability");
  EXPECT_EQ(rows[0].value, 1);
  EXPECT_EQ(rows[1].method, "fair");
}

TEST(Strata, SplitTheTruthsByWhatWasSeenOfThem) {
  const auto all = strata({finder("m", 15)}, config());
  ASSERT_THAT(all, SizeIs(4));
  for (const Stratum& stratum : all) EXPECT_EQ(stratum.truths, 10u);
  EXPECT_EQ(all[0].found, 0u);
  EXPECT_EQ(all[1].found, 5u);
  EXPECT_EQ(all[3].found, 10u);
  EXPECT_FALSE(all[0].b_iou);
  EXPECT_NEAR(*all[3].b_iou, 0.8, 1e-12);
  EXPECT_LT(all[1].recall->low, 0.5);
  EXPECT_GT(all[1].recall->high, 0.5);
  EXPECT_THAT(strataMarkdown(all), HasSubstr("| m | 25 to 50 % | 10 | 0.50 ["));
}

}  // namespace
}  // namespace hydrabench

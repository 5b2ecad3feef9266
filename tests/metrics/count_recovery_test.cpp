// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "metrics/count_recovery.h"

#include <cmath>

#include <gtest/gtest.h>

namespace hydrabench {
namespace {

TEST(FitRatio, FindsTheCountThatRoundsToTheScore) {
  const auto fit = fitRatio({0.787, 0.001}, 89);
  ASSERT_TRUE(fit);
  EXPECT_EQ(fit->count, 70u);
  EXPECT_FALSE(fit->off);
}

TEST(FitRatio, SaysWhereTheScoreWasRoundedAwayFromNearest) {
  const auto fit = fitRatio({0.671, 0.001}, 88);  // 59 / 88 = 0.67045
  ASSERT_TRUE(fit);
  EXPECT_EQ(fit->count, 59u);
  EXPECT_TRUE(fit->off);
}

TEST(FitRatio, HasNoneWhereNoCountIsNear) {
  EXPECT_FALSE(fitRatio({0.787, 0.001}, 10));
  EXPECT_FALSE(fitRatio({0.5, 0.1}, 0));
  EXPECT_FALSE(fitRatio({1.2, 0.1}, 10));
  EXPECT_FALSE(fitRatio({std::nan(""), 0.1}, 10));
}

TEST(FitRatio, TakesAsManyDigitsAsArePrinted) {
  EXPECT_TRUE(fitRatio({0.33, 0.01}, 3));
  EXPECT_FALSE(fitRatio({0.33, 0.0001}, 3));
}

TEST(FitTotals, FindsTheTotalOfSeveralRatiosAndItsMultiples) {
  // 3, 5 and 12 of 13.
  const PrintedScore printed[] = {{0.231}, {0.385}, {0.923}};
  const std::vector<TotalFit> fits = fitTotals(printed, 30);
  ASSERT_EQ(fits.size(), 2u);
  EXPECT_EQ(fits[0].total, 13u);
  EXPECT_EQ(fits[1].total, 26u);
}

TEST(FitTotals, PrefersTotalsWithFewScoresOff) {
  // 1 of 3 is 0.33 to nearest; 10 of 29 is 0.34.
  const PrintedScore printed[] = {{0.34, 0.01}};
  const std::vector<TotalFit> fits = fitTotals(printed, 40);
  ASSERT_FALSE(fits.empty());
  EXPECT_EQ(fits.front().total, 29u);
  EXPECT_EQ(fits.front().off, 0u);
  EXPECT_EQ(fits.back().off, 1u);
}

TEST(FitTotals, IsEmptyWhereNothingFits) {
  const PrintedScore printed[] = {{0.3141592, 1e-7}};
  EXPECT_TRUE(fitTotals(printed, 100).empty());
}

TEST(F1Follows, AllowsRoundingOfPAndR) {
  // 36 / 68 and 36 / 88: 0.4615 before rounding, 0.4613 after.
  EXPECT_TRUE(f1Follows({0.529}, {0.409}, {0.461}));
  EXPECT_TRUE(f1Follows({0.529}, {0.409}, {0.462}));
  EXPECT_FALSE(f1Follows({0.529}, {0.409}, {0.465}));
  EXPECT_FALSE(f1Follows({0.529}, {0.409}, {0.469}));  // the arithmetic mean
}

TEST(F1Follows, IsZeroWhereBothAreZero) { EXPECT_TRUE(f1Follows({0, 0.1}, {0, 0.1}, {0, 0.1})); }

}  // namespace
}  // namespace hydrabench

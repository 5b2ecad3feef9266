// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "metrics/ranking.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace hydrabench {
namespace {

using ::testing::DoubleNear;
using ::testing::ElementsAre;

WorldOutcome world(std::vector<char> found, std::size_t estimates, std::size_t matched) {
  return {estimates, matched, std::move(found)};
}

BootstrapConfig draws(int resamples) {
  BootstrapConfig config;
  config.resamples = resamples;
  return config;
}

TEST(Holm, MultipliesFromTheSmallestOnAndStaysMonotone) {
  // By hand: 3 x 0.01, 2 x 0.03, then 1 x 0.04, which may not be below what came before.
  EXPECT_THAT(
      holmAdjusted({0.01, 0.04, 0.03}),
      ElementsAre(DoubleNear(0.03, 1e-15), DoubleNear(0.06, 1e-15), DoubleNear(0.06, 1e-15)));
}

TEST(Holm, NeverExceedsOneAndLeavesASingleValueAlone) {
  EXPECT_THAT(holmAdjusted({0.6, 0.9}), ElementsAre(1, 1));
  EXPECT_THAT(holmAdjusted({0.2}), ElementsAre(0.2));
  EXPECT_THAT(holmAdjusted({}), ElementsAre());
}

TEST(RankProbabilities, OfTheSameMethodTwiceAreOneHalf) {
  const std::vector<WorldOutcome> method = {world({1, 1, 1}, 3, 3)};
  EXPECT_THAT(rankProbabilities({method, method}, draws(200)),
              ElementsAre(ElementsAre(0.5, 0.5), ElementsAre(0.5, 0.5)));
}

TEST(RankProbabilities, AreSureWhereOneFindsEverythingAndTheOtherNothing) {
  const auto above = rankProbabilities({{world({1, 1}, 2, 2)}, {world({0, 0}, 2, 0)}}, draws(200));
  EXPECT_EQ(above[0][1], 1);
  EXPECT_EQ(above[1][0], 0);
}

TEST(RankProbabilities, DrawWorldsNotOnlyObjects) {
  // A finds the one object of world 0, nothing else is ever found: A is ahead unless both draws are
  // world 1 (1/4), which is a tie: 3/4 + 1/8.
  const std::vector<WorldOutcome> a = {world({1}, 1, 1), world({0}, 1, 0)};
  const std::vector<WorldOutcome> b = {world({0}, 1, 0), world({0}, 1, 0)};
  const auto above = rankProbabilities({a, b}, draws(20000));
  EXPECT_NEAR(above[0][1], 0.875, 0.01);
  EXPECT_NEAR(above[0][1] + above[1][0], 1, 1e-12);
}

TEST(RankProbabilities, DrawTheSameObjectsForAllMethods) {
  // B finds what A finds and one more, without a wrong estimate on either side: never behind.
  const auto above =
      rankProbabilities({{world({1, 0, 1, 0}, 2, 2)}, {world({1, 1, 1, 0}, 3, 3)}}, draws(2000));
  // A tie wherever object 1 is not drawn: (3/4)^4.
  EXPECT_NEAR(above[1][0], 1 - 0.5 * 81.0 / 256, 0.02);
}

}  // namespace
}  // namespace hydrabench

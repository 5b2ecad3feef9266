// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "metrics/scene_tally.h"

#include <array>

#include <gtest/gtest.h>

namespace hydrabench {
namespace {

SceneTally square(double ground_m2, double covered_m2) {
  SceneTally tally;
  tally.ground_m2 = {ground_m2, 0, 10};
  tally.covered_ground_m2 = {covered_m2, 0, 5};
  tally.truth_points = 4;
  tally.truth_distance_m = 2;
  tally.truth_within = {1, 2, 3};
  tally.estimate_points = 2;
  tally.estimate_distance_m = 0.5;
  tally.estimate_within = {1, 1, 2};
  tally.ground_points = 2;
  tally.ground_square_error_m2 = 0.08;
  tally.boundary_m = 3;
  tally.filled_m3["kerb"] = 0.5;
  return tally;
}

TEST(SceneTally, SumsAddUpOverSquares) {
  const std::array tallies = {square(10, 10), square(30, 15)};
  const SceneTally all = total(tallies);
  EXPECT_EQ(groundCompleteness(all, 0), 25.0 / 40);
  EXPECT_EQ(groundCompleteness(all, 2), 0.5);
  EXPECT_EQ(groundCompleteness(all), 35.0 / 60);
  EXPECT_EQ(groundHoleArea(all), 25);
  EXPECT_EQ(all.boundary_m, 6);
  EXPECT_EQ(all.filled_m3.at("kerb"), 1);
}

TEST(SceneTally, HasTheMeansOfItsSums) {
  const SceneTally tally = square(10, 10);
  EXPECT_DOUBLE_EQ(*groundRms(tally), 0.2);
  EXPECT_DOUBLE_EQ(*sceneAccuracy(tally), 0.25);
  EXPECT_DOUBLE_EQ(*sceneCompleteness(tally), 0.5);
  EXPECT_DOUBLE_EQ(*sceneFScore(tally, 0), 2 * 0.5 * 0.25 / 0.75);
  EXPECT_DOUBLE_EQ(*sceneFScore(tally, 2), 2 * 1 * 0.75 / 1.75);
}

TEST(SceneTally, IsUndefinedWhereThereIsNothing) {
  SceneTally tally;
  EXPECT_FALSE(groundCompleteness(tally));
  EXPECT_FALSE(groundRms(tally));
  EXPECT_FALSE(sceneAccuracy(tally));
  EXPECT_FALSE(sceneCompleteness(tally));
  EXPECT_FALSE(sceneFScore(tally, 0));
  EXPECT_FALSE(groundCompleteness(square(10, 1), 1));  // no ground in this band
  tally.truth_points = 4;                              // a truth and no estimate: nothing is found
  EXPECT_EQ(sceneFScore(tally, 0), 0);
  EXPECT_FALSE(sceneCompleteness(tally));
}

}  // namespace
}  // namespace hydrabench

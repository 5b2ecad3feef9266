// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/report/violin.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

namespace hydrabench {
namespace {

double widthAt(const ViolinShape& shape, double value) {
  const auto nearest = std::min_element(
      shape.outline.begin(), shape.outline.end(), [&](const auto& a, const auto& b) {
        return std::abs(a.value - value) < std::abs(b.value - value);
      });
  return nearest->width;
}

TEST(Violin, EndsAtTheLeastAndTheGreatestValue) {
  const auto shape = violinShape({4, 1, 2, 3}, false);
  ASSERT_TRUE(shape);
  EXPECT_EQ(shape->outline.front().value, 1);
  EXPECT_EQ(shape->outline.back().value, 4);
  EXPECT_EQ(shape->p25, 1);
  EXPECT_EQ(shape->median, 2);
  EXPECT_EQ(shape->p75, 3);
}

TEST(Violin, IsTheDensityByHand) {
  // Deviation 1, quartiles 2 apart: the kernel is 0.9 * 2^(-1/5) = 0.7835 wide. Its two bumps at 0
  // and 2 give 1 + exp(-2 / 0.7835^2) = 1.0385 at 0 and 2 exp(-1 / (2 0.7835^2)) = 0.8857 at 1. (A
  // little inside of 0 it is densest, at 1.0387.)
  const auto shape = violinShape({0, 2}, false);
  EXPECT_NEAR(widthAt(*shape, 1) / widthAt(*shape, 0), 0.8857 / 1.0385, 1e-3);
  EXPECT_NEAR(widthAt(*shape, 0), widthAt(*shape, 2), 1e-12);
  EXPECT_EQ(std::max_element(shape->outline.begin(), shape->outline.end(),
                             [](const auto& a, const auto& b) { return a.width < b.width; })
                ->width,
            1);
}

TEST(Violin, IsWideWhereTheValuesAre) {
  const auto shape = violinShape({1, 1.1, 0.9, 1, 1.05, 0.95, 9}, false);
  EXPECT_GT(widthAt(*shape, 1), 0.9);
  EXPECT_LT(widthAt(*shape, 5), 0.1);
}

TEST(Violin, OfLogarithmsIsAsTallAboveAsBelow) {
  const auto shape = violinShape({1, 10, 100}, true);
  EXPECT_NEAR(shape->outline.front().value, 1, 1e-12);
  EXPECT_NEAR(shape->outline.back().value, 100, 1e-9);
  EXPECT_NEAR(widthAt(*shape, 1), widthAt(*shape, 100), 1e-9);
  EXPECT_NEAR(shape->outline[shape->outline.size() / 2].value, 10, 1e-9);
}

TEST(Violin, OfEqualValuesIsALineAndOfNoneNothing) {
  const auto shape = violinShape({3, 3}, true);
  ASSERT_EQ(shape->outline.size(), 1u);
  EXPECT_EQ(shape->outline[0].value, 3);
  EXPECT_EQ(shape->outline[0].width, 1);
  EXPECT_FALSE(violinShape({}, false));
}

}  // namespace
}  // namespace hydrabench

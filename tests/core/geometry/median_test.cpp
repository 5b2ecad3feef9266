// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "core/geometry/median.h"

#include <algorithm>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "core/types/random.h"

namespace hydrabench {
namespace {

using Values = std::vector<double>;

TEST(Median, IsTheValueInTheMiddle) {
  EXPECT_EQ(median(Values{7}), 7);
  EXPECT_EQ(median(Values{3, -1, 2}), 2);
  EXPECT_EQ(median(Values{5, 1, 5, 1, 5}), 5);
}

TEST(Median, OfAnEvenNumberIsTheUpperOfTheTwoInTheMiddle) {
  EXPECT_EQ(median(Values{1, 2}), 2);
  EXPECT_EQ(median(Values{4, 1, 3, 2}), 3);
}

TEST(Median, InfinityIsAValueLikeAnyOther) {
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(median(Values{infinity, 1, 2}), 2);
  EXPECT_EQ(median(Values{infinity, 1}), infinity);
}

TEST(Median, IsThatOfTheSortedValuesAndLeavesTheirOrder) {
  Random random(5);
  for (std::size_t count = 1; count < 60; ++count) {
    Values values;
    for (std::size_t i = 0; i < count; ++i) values.push_back(random.index(20));  // some are equal
    const Values before = values;
    const double found = median(values);
    EXPECT_EQ(values, before);
    std::sort(values.begin(), values.end());
    EXPECT_EQ(found, values[count / 2]) << count;
  }
}

TEST(Median, OfPointsIsThatOfEachCoordinate) {
  const std::vector<Eigen::Vector3d> points = {{1, 9, 0}, {2, 8, -5}, {3, 7, 5}, {4, 6, 6}};
  EXPECT_EQ(median(points), Eigen::Vector3d(3, 8, 5));
  EXPECT_EQ(median(std::span(points).first(3)), Eigen::Vector3d(2, 8, 0));
}

}  // namespace
}  // namespace hydrabench

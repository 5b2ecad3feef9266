// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "core/geometry/nearest_neighbor.h"

#include <cmath>
#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/parallel/parallel_for.h"
#include "core/types/error.h"
#include "core/types/random.h"
#include "tests/support/python_oracle.h"

namespace hydrabench {
namespace {

std::vector<Eigen::Vector3d> drawPoints(std::size_t count, std::uint64_t seed, double offset = 0) {
  std::vector<Eigen::Vector3d> points;
  for (std::size_t i = 0; i < count; ++i) {
    Random random(seed, i);
    const double x = random.uniform();
    const double y = random.uniform();
    points.emplace_back(x + offset, y + offset, random.uniform() + offset);
  }
  return points;
}

TEST(NearestNeighbor, AgreesWithTryingEveryPoint) {
  const auto points = drawPoints(2000, 1, 1000.1);
  const NearestNeighbor tree(points);
  for (const Eigen::Vector3d& query : drawPoints(300, 2, 1000.2)) {
    NearestNeighbor::Match expected{0, (points[0] - query).squaredNorm()};
    for (std::size_t i = 1; i < points.size(); ++i) {
      const double squared = (points[i] - query).squaredNorm();
      if (squared < expected.squared_distance) expected = {i, squared};
    }
    const NearestNeighbor::Match match = tree.nearest(query);
    EXPECT_EQ(match.index, expected.index);
    EXPECT_DOUBLE_EQ(match.squared_distance, expected.squared_distance);
  }
}

TEST(NearestNeighbor, OfAPointOfTheSetIsThatPointAtDistanceZero) {
  const auto points = drawPoints(500, 3);
  const NearestNeighbor tree(points);
  for (std::size_t i = 0; i < points.size(); ++i) {
    EXPECT_EQ(tree.nearest(points[i]).index, i);
    EXPECT_EQ(tree.nearest(points[i]).squared_distance, 0);
  }
}

TEST(NearestNeighbor, TakesTheFirstOfEquallyNearPoints) {
  // A lattice: every cell centre is equally far from its eight corners. Each point twice.
  std::vector<Eigen::Vector3d> points;
  for (int i = 0; i < 2 * 512; ++i) points.emplace_back(i % 8, i / 8 % 8, i / 64 % 8);
  const NearestNeighbor tree(points);
  EXPECT_EQ(tree.nearest({3.5, 4.5, 5.5}).index, 3u + 8 * 4 + 64 * 5);
  EXPECT_EQ(tree.nearest({3, 4, 5}).index, 3u + 8 * 4 + 64 * 5);
  EXPECT_EQ(tree.nearest({-7, 4, 5}).index, 8u * 4 + 64 * 5);
}

TEST(NearestNeighbor, FindsAllWithinARadiusInclusive) {
  std::vector<Eigen::Vector3d> points;
  for (int i = 0; i < 1000; ++i)
    points.emplace_back(0.1 * (i % 10), 0.1 * (i / 10 % 10), 0.1 * (i / 100));
  const NearestNeighbor tree(points);
  const Eigen::Vector3d query = points[555];
  for (const double radius : {0.0, 0.05, (points[556] - points[555]).norm(), 0.25, 10.0}) {
    std::vector<std::size_t> expected;
    for (std::size_t i = 0; i < points.size(); ++i) {
      if ((points[i] - query).squaredNorm() <= radius * radius) expected.push_back(i);
    }
    EXPECT_EQ(tree.within(query, radius), expected);
  }
}

TEST(NearestNeighbor, WorksOnOnePointAndOnManyInOnePlace) {
  const std::vector<Eigen::Vector3d> one = {{1, 2, 3}};
  EXPECT_EQ(NearestNeighbor(one).nearest({1, 2, 5}).squared_distance, 4);
  const std::vector<Eigen::Vector3d> same(100, Eigen::Vector3d(1, 2, 3));
  EXPECT_EQ(NearestNeighbor(same).nearest({1, 2, 5}).index, 0u);
  EXPECT_EQ(NearestNeighbor(same).within({1, 2, 3}, 0).size(), 100u);
}

TEST(NearestNeighbor, RefusesAnEmptySet) {
  EXPECT_THROW(NearestNeighbor(std::vector<Eigen::Vector3d>()), InputError);
}

TEST(NearestNeighbor, AnswersManyQueriesLikeSingleOnesOnAnyNumberOfThreads) {
  const auto points = drawPoints(3000, 4);
  const auto queries = drawPoints(3000, 5);
  const NearestNeighbor tree(points);
  for (const int num_threads : {1, 2, 7}) {
    setNumThreads(num_threads);
    const auto matches = tree.nearest(queries);
    setNumThreads(0);
    for (std::size_t i = 0; i < queries.size(); ++i) {
      EXPECT_EQ(matches[i].index, tree.nearest(queries[i]).index);
    }
  }
}

TEST(NearestNeighbor, AgreesWithScipy) {
  const auto points = drawPoints(2000, 6, -3.3);
  const auto queries = drawPoints(2000, 7, -3.2);
  std::string input = fmt::format("{} {}\n", points.size(), queries.size());
  for (const auto& set : {points, queries}) {
    for (const Eigen::Vector3d& p : set) input += fmt::format("{} {} {}\n", p.x(), p.y(), p.z());
  }
  const OracleAnswer answer = askPython({"numpy", "scipy"}, R"(
import sys, numpy, scipy.spatial
n, m = map(int, sys.stdin.readline().split())
rows = numpy.loadtxt(sys.stdin)
for d in scipy.spatial.cKDTree(rows[:n]).query(rows[n:])[0]:
    print(repr(float(d)))
)",
                                        input);
  if (!answer.output) GTEST_SKIP() << answer.reason;
  std::istringstream lines(*answer.output);
  const NearestNeighbor tree(points);
  for (const Eigen::Vector3d& query : queries) {
    double expected = -1;
    ASSERT_TRUE(lines >> expected);
    EXPECT_NEAR(std::sqrt(tree.nearest(query).squared_distance), expected, 1e-6 * expected);
  }
}

}  // namespace
}  // namespace hydrabench

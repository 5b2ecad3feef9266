// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "core/geometry/assignment.h"

#include <algorithm>
#include <limits>
#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/types/random.h"
#include "tests/support/python_oracle.h"

namespace hydrabench {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::Pair;

constexpr double kForbidden = std::numeric_limits<double>::infinity();

double totalOf(const Eigen::MatrixXd& cost, const Assignment& pairs) {
  double total = 0;
  for (const auto& [row, column] : pairs)
    total += cost(static_cast<Eigen::Index>(row), static_cast<Eigen::Index>(column));
  return total;
}

/// Tries every set of allowed pairs.
struct Exhaustive {
  const Eigen::MatrixXd& cost;
  Assignment current;
  Assignment best;
  bool betterThanBest() const {
    if (current.size() != best.size()) return current.size() > best.size();
    const double total = totalOf(cost, current);
    const double best_total = totalOf(cost, best);
    return total != best_total ? total < best_total : current < best;
  }
  void search(Eigen::Index row, unsigned taken) {
    if (row == cost.rows()) {
      if (betterThanBest()) best = current;
      return;
    }
    search(row + 1, taken);
    for (Eigen::Index column = 0; column < cost.cols(); ++column) {
      if ((taken >> column & 1u) || cost(row, column) == kForbidden) continue;
      current.emplace_back(row, column);
      search(row + 1, taken | 1u << column);
      current.pop_back();
    }
  }
};

/// Small whole costs, so that most matrices have many optimal assignments, and a share of forbidden
/// pairs.
Eigen::MatrixXd drawCosts(std::uint64_t seed, Eigen::Index rows, Eigen::Index columns,
                          std::uint32_t levels, double forbidden) {
  Random random(seed);
  Eigen::MatrixXd cost(rows, columns);
  for (double& value : cost.reshaped()) {
    value = random.index(levels) * 0.25;
    if (random.chance(forbidden)) value = kForbidden;
  }
  return cost;
}

TEST(AssignGated, AgreesWithTryingEverything) {
  for (std::uint64_t seed = 0; seed < 3000; ++seed) {
    Random random(seed, 1);
    const auto rows = static_cast<Eigen::Index>(1 + random.index(5));
    const auto columns = static_cast<Eigen::Index>(1 + random.index(5));
    const Eigen::MatrixXd cost =
        drawCosts(seed, rows, columns, 1 + random.index(4), random.uniform(0, 0.8));
    Exhaustive exhaustive{cost, {}, {}};
    exhaustive.search(0, 0);
    EXPECT_EQ(assignGated(cost), exhaustive.best) << cost;
  }
}

TEST(AssignGated, AgreesWithTryingEverythingWhereCostsAreNegative) {
  for (std::uint64_t seed = 0; seed < 500; ++seed) {
    const Eigen::MatrixXd cost = drawCosts(seed, 4, 5, 5, 0.4).array() - 0.5;
    Exhaustive exhaustive{cost, {}, {}};
    exhaustive.search(0, 0);
    EXPECT_EQ(assignGated(cost), exhaustive.best) << cost;
  }
}

TEST(AssignGated, PrefersMorePairsToCheaperOnes) {
  Eigen::MatrixXd cost(2, 2);
  cost << 0.0, 100.0,  //
      100.0, kForbidden;
  EXPECT_THAT(assignGated(cost), ElementsAre(Pair(0, 1), Pair(1, 0)));
}

TEST(AssignGated, PrefersOneMorePairEvenWhereAllOthersBecomeExpensive) {
  // A chain: n free pairs on the diagonal below, or n + 1 pairs of the highest cost on it.
  constexpr Eigen::Index kSize = 12;
  Eigen::MatrixXd cost = Eigen::MatrixXd::Constant(kSize, kSize, kForbidden);
  cost.diagonal().setConstant(7);
  cost.diagonal<-1>().setZero();
  EXPECT_EQ(assignGated(cost).size(), 12u);
  cost.diagonal<-1>().setConstant(-7);
  EXPECT_EQ(assignGated(cost).size(), 12u);
}

TEST(AssignGated, BreaksTiesByTheSmallestList) {
  EXPECT_THAT(assignGated(Eigen::MatrixXd::Zero(2, 3)), ElementsAre(Pair(0, 0), Pair(1, 1)));
  EXPECT_THAT(assignGated(Eigen::MatrixXd::Zero(3, 2)), ElementsAre(Pair(0, 0), Pair(1, 1)));
}

TEST(AssignGated, GivesTheSamePairsHoweverRowsAndColumnsAreOrdered) {
  // Costs without ties: the optimum is unique, so its pairs must follow their rows and columns.
  Eigen::MatrixXd cost(30, 40);
  Random random(3);
  for (double& value : cost.reshaped()) {
    value = random.uniform();
    if (value > 0.3) value = kForbidden;
  }
  const Assignment expected = assignGated(cost);
  EXPECT_GT(expected.size(), 20u);
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const auto shuffled = [&](Eigen::Index count, std::uint64_t stream) {
      std::vector<std::pair<std::uint64_t, Eigen::Index>> keys;
      Random shuffle(seed, stream);
      for (Eigen::Index i = 0; i < count; ++i) keys.emplace_back(shuffle.bits(), i);
      std::sort(keys.begin(), keys.end());
      std::vector<Eigen::Index> order;
      for (const auto& [key, index] : keys) order.push_back(index);
      return order;
    };
    const auto rows = shuffled(cost.rows(), 1);
    const auto columns = shuffled(cost.cols(), 2);
    Assignment back;
    for (const auto& [row, column] : assignGated(Eigen::MatrixXd(cost(rows, columns))))
      back.emplace_back(rows[row], columns[column]);
    std::sort(back.begin(), back.end());
    EXPECT_EQ(back, expected);
  }
}

TEST(AssignGated, OfNothingOrOnlyForbiddenPairsIsEmpty) {
  EXPECT_THAT(assignGated(Eigen::MatrixXd(0, 0)), IsEmpty());
  EXPECT_THAT(assignGated(Eigen::MatrixXd(0, 3)), IsEmpty());
  EXPECT_THAT(assignGated(Eigen::MatrixXd(3, 0)), IsEmpty());
  EXPECT_THAT(assignGated(Eigen::MatrixXd::Constant(3, 2, kForbidden)), IsEmpty());
}

TEST(AssignMinCost, AgreesWithTryingEverything) {
  for (std::uint64_t seed = 0; seed < 1000; ++seed) {
    Random random(seed, 2);
    const Eigen::MatrixXd cost = drawCosts(seed, 1 + random.index(5), 1 + random.index(5), 20, 0);
    Exhaustive exhaustive{cost, {}, {}};
    exhaustive.search(0, 0);
    const Assignment pairs = assignMinCost(cost);
    EXPECT_EQ(pairs.size(), static_cast<std::size_t>(std::min(cost.rows(), cost.cols())));
    EXPECT_EQ(totalOf(cost, pairs), totalOf(cost, exhaustive.best)) << cost;
    EXPECT_TRUE(std::is_sorted(pairs.begin(), pairs.end()));
  }
}

TEST(AssignMinCost, OfNothingIsEmpty) {
  EXPECT_THAT(assignMinCost(Eigen::MatrixXd(0, 4)), IsEmpty());
  EXPECT_THAT(assignMinCost(Eigen::MatrixXd(4, 0)), IsEmpty());
}

TEST(AssignMinCost, AgreesWithScipy) {
  std::string input;
  std::vector<Eigen::MatrixXd> costs;
  for (const auto& [rows, columns] :
       {std::pair(60, 60), std::pair(40, 90), std::pair(90, 40), std::pair(1, 7)}) {
    Random random(static_cast<std::uint64_t>(rows));
    Eigen::MatrixXd cost(rows, columns);
    for (double& value : cost.reshaped()) value = random.normal();
    input += fmt::format("{} {}", rows, columns);
    for (Eigen::Index r = 0; r < rows; ++r) {
      for (Eigen::Index c = 0; c < columns; ++c) input += fmt::format(" {}", cost(r, c));
    }
    input += '\n';
    costs.push_back(std::move(cost));
  }
  const OracleAnswer answer = askPython({"numpy", "scipy"}, R"(
import sys, numpy, scipy.optimize
for line in sys.stdin:
    values = line.split()
    cost = numpy.array(values[2:], float).reshape(int(values[0]), int(values[1]))
    rows, columns = scipy.optimize.linear_sum_assignment(cost)
    print(len(rows), *[v for pair in zip(rows, columns) for v in pair])
)",
                                        input);
  if (!answer.output) GTEST_SKIP() << answer.reason;
  std::istringstream numbers(*answer.output);
  for (const Eigen::MatrixXd& cost : costs) {
    std::size_t count = 0;
    numbers >> count;
    Assignment expected(count);
    for (auto& [row, column] : expected) numbers >> row >> column;
    EXPECT_EQ(assignMinCost(cost), expected);
    EXPECT_EQ(assignGated(cost), expected);
  }
}

}  // namespace
}  // namespace hydrabench

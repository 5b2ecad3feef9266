// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "core/parallel/parallel_for.h"

#include <atomic>
#include <chrono>
#include <cmath>
#include <mutex>
#include <set>
#include <stdexcept>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace hydrabench {
namespace {

/// Every test for several numbers of threads, more than this machine may have included.
class ParallelFor : public ::testing::TestWithParam<int> {
 protected:
  void SetUp() override { setNumThreads(GetParam()); }
  void TearDown() override { setNumThreads(0); }
};
INSTANTIATE_TEST_SUITE_P(Threads, ParallelFor, ::testing::Values(1, 2, 7));

TEST_P(ParallelFor, VisitsEveryIndexOnce) {
  std::vector<int> visits(1000, 0);
  parallelFor(visits.size(), [&](std::size_t i) { ++visits[i]; });
  EXPECT_THAT(visits, ::testing::Each(1));
}

TEST_P(ParallelFor, DoesNothingForNoIndices) {
  parallelFor(0, [](std::size_t) { FAIL(); });
}

TEST_P(ParallelFor, CutsRangesByCountAndGrainOnly) {
  std::mutex mutex;
  std::set<std::pair<std::size_t, std::size_t>> ranges;
  parallelForRanges(10, 4, [&](std::size_t begin, std::size_t end) {
    const std::lock_guard lock(mutex);
    ranges.emplace(begin, end);
  });
  EXPECT_THAT(ranges,
              ::testing::ElementsAre(std::pair(0u, 4u), std::pair(4u, 8u), std::pair(8u, 10u)));
}

TEST_P(ParallelFor, TakesAGrainOfZeroAsOne) {
  std::atomic<int> count = 0;
  parallelFor(
      5, [&](std::size_t) { ++count; }, 0);
  EXPECT_EQ(count, 5);
}

TEST_P(ParallelFor, ReportsTheErrorOfTheLowestIndex) {
  for (int repetition = 0; repetition < 20; ++repetition) {
    std::atomic<int> calls = 0;
    try {
      parallelFor(100, [&](std::size_t i) {
        ++calls;
        if (i % 10 == 3) throw std::runtime_error(std::to_string(i));
      });
      FAIL() << "no exception";
    } catch (const std::runtime_error& error) {
      EXPECT_STREQ(error.what(), "3");
    }
    EXPECT_EQ(calls, 100);
  }
}

TEST_P(ParallelFor, ReportsTheFirstErrorOfARange) {
  try {
    parallelFor(
        100,
        [](std::size_t i) {
          if (i >= 37) throw std::runtime_error(std::to_string(i));
        },
        10);
    FAIL() << "no exception";
  } catch (const std::runtime_error& error) {
    EXPECT_STREQ(error.what(), "37");
  }
}

TEST_P(ParallelFor, CombinesInIndexOrder) {
  const std::string word = parallelReduce(
      26, std::string(), [](std::size_t i) { return static_cast<char>('a' + i); },
      [](std::string& sum, char letter) { sum += letter; });
  EXPECT_EQ(word, "abcdefghijklmnopqrstuvwxyz");
}

TEST_P(ParallelFor, MayBeNested) {
  std::vector<std::vector<int>> visits(20, std::vector<int>(50, 0));
  parallelFor(visits.size(), [&](std::size_t i) {
    parallelFor(visits[i].size(), [&](std::size_t k) { ++visits[i][k]; });
  });
  for (const auto& row : visits) EXPECT_THAT(row, ::testing::Each(1));
}

TEST_P(ParallelFor, DoesNotTakeUpOuterWorkWhileItWaitsForAnInnerLoop) {
  std::atomic<int> mixed = 0;
  parallelFor(64, [&](std::size_t) {
    thread_local int depth = 0;
    if (depth > 0) ++mixed;
    ++depth;
    parallelFor(16, [](std::size_t) { std::this_thread::yield(); });
    --depth;
  });
  EXPECT_EQ(mixed, 0);
}

TEST_P(ParallelFor, PublishesWhatWasWrittenBeforeAndInside) {
  // Plain memory handed in and out again: this is what the thread sanitizer looks at.
  std::vector<double> numbers(5000, 1.0);
  for (int round = 0; round < 10; ++round) {
    for (double& number : numbers) number += 1;
    parallelFor(
        numbers.size(), [&](std::size_t i) { numbers[i] *= 1.5; }, 64);
  }
  double sum = 0;
  for (const double number : numbers) sum += number;
  EXPECT_DOUBLE_EQ(sum, 5000 * (std::pow(1.5, 10) + 3 * (std::pow(1.5, 10) - 1)));
}

TEST_P(ParallelFor, ReportsItsNumberOfThreads) { EXPECT_EQ(numThreads(), GetParam()); }

TEST_P(ParallelFor, UsesSeveralThreadsWhereAsked) {
  std::mutex mutex;
  std::set<std::thread::id> ids;
  parallelFor(64, [&](std::size_t) {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
    const std::lock_guard lock(mutex);
    ids.insert(std::this_thread::get_id());
  });
  EXPECT_LE(ids.size(), static_cast<std::size_t>(GetParam()));
  if (GetParam() == 1) {
    EXPECT_EQ(*ids.begin(), std::this_thread::get_id());
  }
}

TEST_P(ParallelFor, KeepsLibrariesOnOneThreadWhereAsked) {
  std::atomic<int> calls = 0;
  const std::thread::id caller = std::this_thread::get_id();
  std::thread::id seen;
  runOnThisThreadOnly([&] {
    ++calls;
    seen = std::this_thread::get_id();
  });
  EXPECT_EQ(calls, 1);
  EXPECT_EQ(seen, caller);
}

TEST(ParallelReduce, IsBitwiseEqualForAnyNumberOfThreads) {
  const auto sum = [](int num_threads) {
    setNumThreads(num_threads);
    // 1 / (i + 1) does not add up to the same double in another order.
    const double result = parallelReduce(
        20000, 0.0, [](std::size_t i) { return 1.0 / static_cast<double>(i + 1); },
        [](double& total, double value) { total += value; });
    setNumThreads(0);
    return result;
  };
  const double serial = sum(1);
  EXPECT_EQ(sum(2), serial);
  EXPECT_EQ(sum(7), serial);
}

}  // namespace
}  // namespace hydrabench

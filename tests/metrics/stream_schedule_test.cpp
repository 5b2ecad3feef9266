// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "metrics/stream_schedule.h"

#include <gtest/gtest.h>

namespace hydrabench {
namespace {

/// By hand: the first comes at 1 s and takes until 5 s; the second comes at 2 s, waits until 5 and
/// takes until 9; the third comes at 8 s, waits until 9 and takes until 10.
std::vector<StreamRequest> threeRequests(double deadline_s) {
  std::vector<StreamRequest> requests = {{1, 4}, {2, 4}, {8, 1}};
  for (StreamRequest& request : requests) request.due_s = request.arrival_s + deadline_s;
  return requests;
}
const std::vector<StreamRequest> kThree = threeRequests(5);

TEST(StreamSchedule, ThreeObjectsByHand) {
  const auto done = schedule(kThree, 1);
  ASSERT_EQ(done.size(), 3u);
  EXPECT_EQ(done[0].start_s, 1);
  EXPECT_EQ(done[0].end_s, 5);
  EXPECT_FALSE(done[0].late);
  EXPECT_EQ(done[1].start_s, 5);
  EXPECT_EQ(done[1].end_s, 9);
  EXPECT_TRUE(done[1].late);  // 7 s after it came
  EXPECT_EQ(done[2].start_s, 9);
  EXPECT_EQ(done[2].end_s, 10);
  EXPECT_FALSE(done[2].late);
}

TEST(StreamSchedule, AFasterOrASecondEstimatorLeavesNobodyWaiting) {
  for (const StreamRequest& request : kThree) {
    const std::size_t i = static_cast<std::size_t>(&request - kThree.data());
    EXPECT_EQ(schedule(kThree, 2)[i].start_s, request.arrival_s);
  }
  const std::vector<StreamRequest> fast = {{1, 0.5}, {2, 0.5}, {8, 0.5}};
  EXPECT_EQ(schedule(fast, 1)[1].end_s, 2.5);
}

TEST(StreamSchedule, ServesByArrivalWhateverTheOrderOfTheList) {
  const std::vector<StreamRequest> reversed = {kThree[2], kThree[1], kThree[0]};
  const auto done = schedule(reversed, 1);
  EXPECT_EQ(done[0].end_s, 10);
  EXPECT_EQ(done[1].end_s, 9);
  EXPECT_EQ(done[2].end_s, 5);
  const std::vector<StreamRequest> together = {{3, 2}, {3, 1}};
  EXPECT_EQ(schedule(together, 1)[1].end_s, 6);
}

TEST(StreamSchedule, TheDeadlineItselfIsInTime) {
  EXPECT_FALSE(schedule(threeRequests(7), 1)[1].late);
  EXPECT_TRUE(schedule(threeRequests(6.999), 1)[1].late);
  EXPECT_TRUE(schedule({}, 1).empty());
}

TEST(StreamSchedule, TheQueueIsWhatCameAndWasNotBegun) {
  // The second waits from 2 to 5, the third from 8 to 9; the first never.
  const auto steps = queueLength(kThree, schedule(kThree, 1));
  const std::vector<std::pair<double, double>> expected = {{0, 0}, {2, 1}, {5, 0}, {8, 1}, {9, 0}};
  ASSERT_EQ(steps.size(), expected.size());
  for (std::size_t i = 0; i < steps.size(); ++i) {
    EXPECT_EQ(steps[i].time_s, expected[i].first);
    EXPECT_EQ(steps[i].value, expected[i].second);
  }
  EXPECT_DOUBLE_EQ(meanOverTime(steps, 10), 0.4);
}

TEST(StreamSchedule, MeansOverTimeCountWhatHappensUntilTheEnd) {
  const std::vector<StreamStep> f1 = {{5, 0.5}, {9, 0.8}, {10, 1}};
  EXPECT_DOUBLE_EQ(meanOverTime(f1, 10), (4 * 0.5 + 1 * 0.8) / 10);
  EXPECT_DOUBLE_EQ(meanOverTime(f1, 20), (4 * 0.5 + 1 * 0.8 + 10 * 1) / 20);
  EXPECT_DOUBLE_EQ(meanOverTime(f1, 5), 0);
  EXPECT_DOUBLE_EQ(meanOverTime({}, 5), 0);
}

}  // namespace
}  // namespace hydrabench

// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/experiment/timing.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace hydrabench {
namespace {

/// Calls of 1, 2, ..., count ms.
StageTimes ramp(int count) {
  StageTimes times;
  for (int i = 1; i <= count; ++i) times.add("frame", {static_cast<double>(i), 2.0 * i});
  return times;
}

TEST(Timing, PercentilesAreNearestRanks) {
  const std::vector<TimingRow> rows = timingRows("office", "1", "hydra", ramp(100), {});
  ASSERT_EQ(rows.size(), 1u);
  EXPECT_EQ(rows[0].n, 100u);
  EXPECT_EQ(rows[0].mean_ms, 50.5);
  EXPECT_EQ(rows[0].p50_ms, 50);
  EXPECT_EQ(rows[0].p90_ms, 90);
  EXPECT_EQ(rows[0].p99_ms, 99);
  EXPECT_EQ(rows[0].max_ms, 100);
  EXPECT_NEAR(rows[0].cpu_s, 10.1, 1e-12);
}

TEST(Timing, WarmUpIsLeftOutPerStage) {
  StageTimes times = ramp(4);
  times.add("finish", {7, 7});
  const std::vector<TimingRow> rows =
      timingRows("office", "1", "hydra", times, {{"frame", 3}, {"other", 9}});
  ASSERT_EQ(rows.size(), 2u);
  EXPECT_EQ(rows[0].n, 1u);
  EXPECT_EQ(rows[0].mean_ms, 4);
  EXPECT_EQ(rows[1].stage, "finish");
  EXPECT_EQ(rows[1].n, 1u);
}

TEST(Timing, AStageThatOnlyRanDuringWarmUpKeepsItsCalls) {
  const std::vector<TimingRow> rows = timingRows("office", "1", "hydra", ramp(2), {{"frame", 2}});
  ASSERT_EQ(rows.size(), 1u);
  EXPECT_EQ(rows[0].n, 2u);
}

TEST(Timing, SummaryComparesWithRealTime) {
  // Mean 50 ms a frame and 0 s at the end, at a frame every 100 ms.
  StageTimes times;
  times.add("frame", {50, 50});
  EXPECT_THAT(timingSummary(timingRows("office", "1", "hydra", times, {}), {{"office", 0.1}}),
              ::testing::HasSubstr("2.0x real time"));
}

TEST(StageTimes, AScopeAddsOneSampleToItsStage) {
  StageTimes times;
  { const StageTimes::Scope scope(times, "mesh"); }
  { const StageTimes::Scope scope(times, "mesh"); }
  ASSERT_EQ(times.stages().size(), 1u);
  EXPECT_EQ(times.stages()[0].samples.size(), 2u);
  EXPECT_GE(times.stages()[0].samples[0].wall_ms, 0);
}

}  // namespace
}  // namespace hydrabench

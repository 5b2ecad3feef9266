// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/experiment/stream_replay.h"

#include <algorithm>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "eval/experiment/stream_report.h"

namespace hydrabench {
namespace {

using ::testing::HasSubstr;

constexpr Label kChair = 5;
constexpr std::int64_t kSecond = 1'000'000'000;

Mesh cubeAt(double x) {
  return boxMesh(Aabb(Eigen::Vector3d(x, 0, 0), Eigen::Vector3d(x + 1, 1, 1)));
}

ShapeCandidate candidate(std::uint64_t track, double x, std::int64_t last_seen_s) {
  ShapeCandidate result;
  result.track = track;
  result.label = kChair;
  result.mesh = cubeAt(x);
  result.box = bounds(result.mesh);
  result.overlap = 0.9;
  result.last_observed_ns = (100 + last_seen_s) * kSecond;
  return result;
}

/// Ten seconds with chairs at 0, 10 and 20 m, last seen after 0, 1 and 7 s. A track ends after a
/// second out of view, so their shapes are asked for after 1, 2 and 8 s.
StreamWorld threeChairs() {
  StreamWorld world;
  world.dataset = "by_hand";
  world.seed = 1;
  world.method = "careful";
  world.candidates = {candidate(0, 0, 0), candidate(1, 10, 1), candidate(2, 20, 7)};
  world.counting.label_space = {{{kChair, "chair", {}, true, true}}};
  for (const double x : {0.0, 10.0, 20.0}) {
    const auto id = static_cast<ObjectId>(world.counting.truths.size() + 1);
    world.counting.truths.push_back(detectionObject(id, kChair, cubeAt(x)));
  }
  world.start_ns = 100 * kSecond;
  world.end_ns = 110 * kSecond;
  world.request_after_s = 1;
  return world;
}

/// The same without a shape of the third chair.
StreamWorld twoOfThem() {
  StreamWorld world = threeChairs();
  world.method = "hasty";
  world.candidates[2].failure = "no shape";
  return world;
}

EvaluationConfig oneThreshold() {
  EvaluationConfig config;
  config.thresholds_m = {0.2};
  return config;
}

StreamOutcome replayed(const StreamWorld& world, double latency_s, const StreamConfig& config = {},
                       double factor = 1) {
  return StreamReplay({world}, oneThreshold()).run(constantLatency(latency_s), config, factor);
}

std::vector<std::pair<double, double>> pairs(const std::vector<StreamStep>& steps) {
  std::vector<std::pair<double, double>> result;
  for (const StreamStep& step : steps) result.emplace_back(step.time_s, step.value);
  return result;
}

using Steps = std::vector<std::pair<double, double>>;

// With 4 s for a shape: the first is worked on from 1 to 5 s; the second, asked for after 2 s,
// from 5 to 9; the third, asked for after 8 s, from 9 to 13.
//
// One chair of three: P = 1, R = 1/3, F1 = 1/2. Two: R = 2/3, F1 = 4/5. Three: 1.
TEST(StreamReplay, ThreeObjectsByHand) {
  const StreamOutcome outcome = replayed(threeChairs(), 4);
  ASSERT_EQ(outcome.shapes.size(), 3u);
  EXPECT_EQ(outcome.shapes[1].request.arrival_s, 2);
  EXPECT_EQ(outcome.shapes[1].completion.start_s, 5);
  EXPECT_EQ(outcome.shapes[2].completion.end_s, 13);
  EXPECT_EQ(outcome.lastReady(), 13);
  EXPECT_EQ(outcome.meanLatency(), 4);
  // 5 s after it was asked for: the first has 4, the second 7, the third 5, which is in time.
  EXPECT_EQ(outcome.misses(), 1u);
  // The second waits from 2 to 5, the third from 8 to 9: 4 of 10 s.
  EXPECT_EQ(pairs(outcome.queue), (Steps{{0, 0}, {2, 1}, {5, 0}, {8, 1}, {9, 0}}));
  EXPECT_EQ(outcome.longest_queue, 1);
  EXPECT_DOUBLE_EQ(outcome.mean_queue, 0.4);

  ASSERT_EQ(outcome.scores.size(), 2u);  // exists, one_to_one
  for (const StreamScore& score : outcome.scores) {
    ASSERT_EQ(score.f1.size(), 3u);
    EXPECT_EQ(score.f1[0].time_s, 5);
    EXPECT_DOUBLE_EQ(score.f1[0].value, 0.5);
    EXPECT_EQ(score.f1[1].time_s, 9);
    EXPECT_DOUBLE_EQ(score.f1[1].value, 0.8);
    EXPECT_EQ(score.f1[2].time_s, 13);
    EXPECT_DOUBLE_EQ(score.f1[2].value, 1);
    EXPECT_DOUBLE_EQ(score.area, (4 * 0.5 + 1 * 0.8) / 10);  // up to the end at 10 s
    EXPECT_DOUBLE_EQ(score.f1_at_end, 0.8);
    EXPECT_DOUBLE_EQ(score.f1_of_all, 1);
  }
}

TEST(StreamReplay, WithoutLatencyItIsAsFastAsTracksEnd) {
  // 1/2 from 1 to 2 s, 4/5 to 8, 1 to 10.
  EXPECT_DOUBLE_EQ(replayed(threeChairs(), 0).scores[0].area, (0.5 + 6 * 0.8 + 2) / 10);
}

TEST(StreamReplay, TheTimeAfterTheLastFrameCountsWhereAskedFor) {
  StreamConfig config;
  config.after_s = 5;
  // 1/2 from 5 to 9, 4/5 to 13, 1 to 15.
  const StreamOutcome outcome = replayed(threeChairs(), 4, config);
  EXPECT_DOUBLE_EQ(outcome.scores[0].area, (4 * 0.5 + 4 * 0.8 + 2) / 15);
  EXPECT_EQ(outcome.scores[0].f1_at_end, 1);
}

TEST(StreamReplay, ADeadlineFromTheLastObservationIsReachedEarlier) {
  StreamConfig config;
  config.deadline_from_last_seen = true;
  // Due after 5, 6 and 12 s; ready after 5, 9 and 13.
  EXPECT_EQ(replayed(threeChairs(), 4, config).misses(), 2u);
}

TEST(StreamReplay, TwoEstimatorsDoNotLetTheSecondWait) {
  StreamConfig config;
  config.servers = 2;
  const StreamOutcome outcome = replayed(threeChairs(), 4, config);
  EXPECT_EQ(outcome.shapes[1].completion.end_s, 6);
  EXPECT_EQ(outcome.longest_queue, 0);
}

TEST(StreamReplay, WhatTheRunRejectedNeverCountsButTakesItsTime) {
  StreamWorld world = threeChairs();
  world.candidates[0].overlap = 0.1;
  const StreamOutcome outcome = replayed(world, 4);
  EXPECT_EQ(outcome.shapes[1].completion.end_s, 9);
  EXPECT_EQ(outcome.scores[0].f1[0].value, 0);
  EXPECT_DOUBLE_EQ(outcome.scores[0].f1_of_all, 0.8);
}

TEST(StreamReplay, WhatWasSeenOfARejectedObjectIsThereWhenItsVerdictIs) {
  StreamWorld world = threeChairs();
  world.decision.rejected = "partial_mesh";
  world.candidates[1].overlap = 0.1;
  world.candidates[1].partial_mesh = cubeAt(10);
  const std::vector<StreamStep> f1 = replayed(world, 4).scores[0].f1;
  EXPECT_DOUBLE_EQ(f1[0].value, 0.5);
  EXPECT_DOUBLE_EQ(f1[1].value, 0.8);
}

TEST(StreamReplay, TracksThatLastToTheEndAreAskedForThere) {
  StreamWorld world = threeChairs();
  world.candidates[2].last_observed_ns = world.end_ns;
  EXPECT_EQ(replayed(world, 4).shapes[2].request.arrival_s, 10);
}

TEST(StreamReplay, WorldsLieOverEachOther) {
  StreamWorld second = threeChairs();
  second.seed = 2;
  const StreamReplay both({threeChairs(), second}, oneThreshold());
  const StreamOutcome outcome = both.run(constantLatency(4), {});
  const StreamOutcome single = replayed(threeChairs(), 4);
  EXPECT_EQ(outcome.shapes.size(), 6u);
  EXPECT_EQ(outcome.misses(), 2u);
  EXPECT_EQ(outcome.mean_queue, single.mean_queue);
  EXPECT_EQ(outcome.scores[0].area, single.scores[0].area);
}

TEST(StreamReplay, DrawsByTheTrackAloneAndTheSameEveryTime) {
  const LatencyModel spread = rangedLatency("spread", 2, 1, 5);
  const StreamReplay replay({threeChairs()}, oneThreshold());
  const StreamOutcome first = replay.run(spread, {});
  const StreamOutcome again = replay.run(spread, {});
  StreamWorld reversed = threeChairs();
  std::reverse(reversed.candidates.begin(), reversed.candidates.end());
  const StreamOutcome other = StreamReplay({reversed}, oneThreshold()).run(spread, {});
  std::set<double> different;
  for (std::size_t i = 0; i < 3; ++i) {
    different.insert(first.shapes[i].request.latency_s);
    EXPECT_EQ(first.shapes[i].request.latency_s, again.shapes[i].request.latency_s);
    EXPECT_EQ(first.shapes[i].request.latency_s, other.shapes[2 - i].request.latency_s);
  }
  EXPECT_EQ(different.size(), 3u);
  StreamConfig another_seed;
  another_seed.seed = 2;
  EXPECT_NE(replay.run(spread, another_seed).meanLatency(), first.meanLatency());
}

// The hasty one takes half a second: 1/2 from 1.5 s to 2.5, 4/5 to 10, an area of 0.65. The careful
// one finds all three, with a latency L <= 1 after 1 + L, 2 + L and 8 + L s: an area of (1/2 +
// 6 * 4/5 + 2 - L) / 10 = (7.3 - L) / 10, which is 0.65 at L = 0.8 s, a fifth of its 4 s.
TEST(StreamBreakEven, IsWhereTheAreasMeetByHand) {
  const double area = replayed(twoOfThem(), 0.5).scores[0].area;
  EXPECT_DOUBLE_EQ(area, (0.5 + 7.5 * 0.8) / 10);
  const StreamReplay careful({threeChairs()}, oneThreshold());
  const auto result = breakEven(careful, constantLatency(4), {}, 0, area);
  ASSERT_TRUE(result);
  ASSERT_TRUE(result->latency_s);
  EXPECT_NEAR(*result->latency_s, 0.8, 1e-12);
  EXPECT_NEAR(result->factor, 0.2, 1e-12);
}

TEST(StreamBreakEven, IsNotAskedForWhatIsNotBetter) {
  const StreamReplay hasty({twoOfThem()}, oneThreshold());
  const double area = replayed(threeChairs(), 0).scores[0].area;
  EXPECT_FALSE(breakEven(hasty, constantLatency(4), {}, 0, area));
  EXPECT_FALSE(breakEven(hasty, constantLatency(0), {}, 0, 0));
}

TEST(StreamReport, ComparesMethodsByPair) {
  const StreamReport report = replayStreams(
      {threeChairs(), twoOfThem()},
      {{"careful", {constantLatency(4)}}, {"hasty", {constantLatency(0.5)}}}, {}, oneThreshold());
  ASSERT_EQ(report.rows.size(), 2u);
  ASSERT_EQ(report.break_even.size(), 2u);  // exists, one_to_one
  EXPECT_EQ(report.break_even[0].better, "careful");
  EXPECT_NEAR(*report.break_even[0].result.latency_s, 0.8, 1e-12);
  EXPECT_THAT(streamMarkdown(report), HasSubstr("| careful | 4 s, given | 3 | 4 | 1 | 1 | 0.40 | "
                                                "13.0 |\n"));
  EXPECT_THAT(streamMarkdown(report),
              HasSubstr("| 0.2 m | exists | hasty | 0.5 s, given | 0.650 | 0.690 | 0.800 | 0.800 "
                        "|\n"));
  EXPECT_THAT(streamMarkdown(report),
              HasSubstr("| 0.2 m | exists | careful, 4 s, given | hasty, 0.5 s, given | 0.650 | "
                        "0.280 at 4 s | 0.8 s (0.2 times its own) |\n"));
  EXPECT_THAT(f1OverTimeCsv(report),
              HasSubstr("\nby_hand,1,careful,\"4 s, given\",0.2,exists,5,0.5\n"));
  EXPECT_THAT(queueCsv(report), HasSubstr("\nby_hand,1,careful,\"4 s, given\",8,1\n"));
  EXPECT_THAT(requestsCsv(report),
              HasSubstr("\nby_hand,1,careful,\"4 s, given\",1,1,2,5,9,4,7,1\n"));
}

TEST(StreamReport, PoolsTheWorldsOfADataset) {
  StreamWorld second = threeChairs();
  second.seed = 2;
  const StreamReport report = replayStreams(
      {threeChairs(), second}, {{"careful", {constantLatency(4)}}}, {}, oneThreshold());
  ASSERT_EQ(report.rows.size(), 3u);
  EXPECT_EQ(report.rows[2].seed, "pooled");
  EXPECT_EQ(report.rows[2].outcome.shapes.size(), 6u);
  EXPECT_THAT(streamMarkdown(report), HasSubstr("## by_hand, worlds together"));
}

TEST(StreamReport, PlotsF1AndTheQueue) {
  const StreamReport report =
      replayStreams({threeChairs()}, {{"careful", {constantLatency(4)}}}, {}, oneThreshold());
  const Plot plot = streamPlot(report, "by_hand", Matching::kExists);
  ASSERT_EQ(plot.panels.size(), 2u);
  EXPECT_EQ(plot.panels[0].curves[0].points,
            (std::vector<Eigen::Vector2d>{{0, 0}, {5, 0.5}, {9, 0.8}}));
  EXPECT_EQ(plot.panels[1].x_range, Eigen::Vector2d(0, 10));
}

}  // namespace
}  // namespace hydrabench

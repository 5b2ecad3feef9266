// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/experiment/latency_model.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/types/error.h"
#include "tests/support/temporary_folder.h"

namespace hydrabench {
namespace {

using ::testing::HasSubstr;

/// Mean over shares, by the midpoints of many intervals.
double meanOf(const LatencyModel& model) {
  constexpr int kShares = 100'000;
  double sum = 0;
  for (int i = 0; i < kShares; ++i) sum += model.quantile_s((i + 0.5) / kShares);
  return sum / kShares;
}

TEST(LatencyModel, GoesThroughThePercentilesAndKeepsTheMean) {
  // Lines from 0.5 to p90 and on: 0.4 * 1.5 + 0.09 * 2.5 + 0.01 * 4 = 0.865 of a mean of 1.2; below
  // the median (low + 1) / 2 * 0.5 has to be 0.335, so low is 0.34.
  const LatencyModel model =
      summarizedLatency("by hand", {.mean = 1.2, .p50 = 1, .p90 = 2, .p99 = 3, .max = 5});
  EXPECT_NEAR(model.quantile_s(0), 0.34, 1e-12);
  EXPECT_DOUBLE_EQ(model.quantile_s(0.5), 1);
  EXPECT_DOUBLE_EQ(model.quantile_s(0.7), 1.5);
  EXPECT_DOUBLE_EQ(model.quantile_s(0.9), 2);
  EXPECT_DOUBLE_EQ(model.quantile_s(0.99), 3);
  EXPECT_NEAR(meanOf(model), 1.2, 1e-6);
}

TEST(LatencyModel, OfATimingRowIsInSeconds) {
  TimingRow row;
  row.mean_ms = row.p50_ms = row.p90_ms = row.p99_ms = row.max_ms = 100;
  const LatencyModel model = measuredLatency(row);
  EXPECT_EQ(model.label, "measured");
  EXPECT_DOUBLE_EQ(model.quantile_s(0.25), 0.1);
}

TEST(LatencyModel, OfSamplesGivesEachAsOften) {
  const LatencyModel model = sampledLatency("three", {3, 1, 2});
  EXPECT_EQ(model.quantile_s(0), 1);
  EXPECT_EQ(model.quantile_s(0.34), 2);
  EXPECT_EQ(model.quantile_s(0.999), 3);
}

TEST(PublishedLatency, HasThePublishedMeanAndRange) {
  const LatencyModel indoor = readLatency("published:sam3d_indoor");
  EXPECT_THAT(indoor.label, HasSubstr("published"));
  EXPECT_NEAR(meanOf(indoor), 14.62, 1e-3);
  EXPECT_DOUBLE_EQ(indoor.quantile_s(0), 7);
  EXPECT_LT(indoor.quantile_s(0.9999), 38);
  EXPECT_GT(indoor.quantile_s(0.9999), 37.9);
  EXPECT_NEAR(meanOf(readLatency("published:sam3d_outdoor")), 11.01, 1e-3);
  EXPECT_EQ(readLatency("published:crisp_indoor").quantile_s(0.7), 0.43);
  EXPECT_EQ(publishedLatencies().size(), 4u);
}

TEST(LatencyModel, IsReadFromWords) {
  EXPECT_EQ(readLatency("0.43").quantile_s(0.9), 0.43);
  EXPECT_EQ(readLatency("mean=2").quantile_s(0.01), 2);
  const LatencyModel given = readLatency("p50=2,p90=3");
  EXPECT_EQ(given.quantile_s(0), 1);  // as far below the median as p90 is above it
  EXPECT_EQ(given.quantile_s(0.95), 3);
  EXPECT_NEAR(meanOf(readLatency("mean=1.2,p50=1,p90=2,p99=3,max=5")), 1.2, 1e-6);
}

TEST(LatencyModel, IsReadFromAStudyOfEstimators) {
  const TemporaryFolder folder;
  writeText(folder / "views.csv",
            "estimator,failure,total_wall_ms\nfast,,100\nfast,no pose,1\nslow,,900\nfast,,300\n");
  const std::string file = (folder / "views.csv").string();
  const LatencyModel fast = readLatency(file + ":fast");
  EXPECT_EQ(fast.quantile_s(0), 0.1);
  EXPECT_EQ(fast.quantile_s(0.5), 0.3);
  EXPECT_THAT(messageOf<InputError>([&] { readLatency(file + ":fats"); }),
              HasSubstr("no estimate of 'fats', expected one of fast, slow"));
  writeText(folder / "other.csv", "a,b\n1,2\n");
  EXPECT_THAT(messageOf<InputError>([&] { readLatency((folder / "other.csv:x").string()); }),
              HasSubstr("no column 'estimator', expected views.csv"));
}

TEST(LatencyModel, SaysWhatItDoesNotUnderstand) {
  const auto fault = [](const std::string& text) {
    return messageOf<InputError>([&] { readLatency(text); });
  };
  EXPECT_THAT(fault("fast"), HasSubstr("latency 'fast': expected measured, seconds"));
  EXPECT_THAT(fault("-1"), HasSubstr("expected measured"));
  EXPECT_THAT(fault("published:sam3d_indor"), HasSubstr("did you mean 'sam3d_indoor'?"));
  EXPECT_THAT(fault("p50=2,p90=1"), HasSubstr("p90 is below what comes before it"));
  EXPECT_THAT(fault("p50=2,p75=1"), HasSubstr("'p75=1', expected mean, p50"));
  EXPECT_THAT(fault("p90=2"), HasSubstr("expected mean= or p50="));
}

}  // namespace
}  // namespace hydrabench

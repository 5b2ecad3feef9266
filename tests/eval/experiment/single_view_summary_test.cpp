// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include <cmath>
#include <limits>
#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "eval/experiment/single_view_study.h"

namespace hydrabench {
namespace {

using ::testing::HasSubstr;

SingleViewRow rowOf(const std::string& estimator, const std::string& class_name, double chamfer_m,
                    double v_iou, double total_ms = 10) {
  SingleViewRow row;
  row.dataset = "office";
  row.world_seed = "1";
  row.estimator = estimator;
  row.object = class_name + "_000";
  row.class_name = class_name;
  row.chamfer_l1_m = chamfer_m;
  row.center_error_m = 2 * chamfer_m;
  row.v_iou = v_iou;
  row.b_iou = v_iou;
  row.wall_ms["total"] = total_ms;
  return row;
}

SingleViewRow failureOf(const std::string& estimator, const std::string& class_name) {
  SingleViewRow row = rowOf(estimator, class_name, 0, 0);
  row.failure = "too few points";
  row.chamfer_l1_m = row.center_error_m = row.v_iou = row.b_iou = std::nullopt;
  return row;
}

SingleViewSummary summaryOf(const std::vector<SingleViewRow>& rows, int resamples = 0) {
  return summarize(rows, {.resamples = resamples, .seed = 1}).front();
}

std::vector<std::string> linesOf(const std::string& text) {
  std::istringstream stream(text);
  std::vector<std::string> lines;
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

TEST(SingleViewRow, FailsWithoutAnEstimateOrWithAPlainlyWrongOne) {
  EXPECT_FALSE(rowOf("a", "chair", 0.15, 0.1).failed());
  EXPECT_TRUE(rowOf("a", "chair", 0.1501, 0.5).failed());
  EXPECT_TRUE(rowOf("a", "chair", 0.01, 0.099).failed());
  EXPECT_TRUE(failureOf("a", "chair").failed());
  SingleViewRow unscored = rowOf("a", "chair", 0.01, 0.9);
  unscored.v_iou = std::nullopt;
  EXPECT_TRUE(unscored.failed());
}

TEST(SingleViewSummary, MediansOfOddAndEvenNumbersOfObjects) {
  const SingleViewSummary three = summaryOf(
      {rowOf("a", "bin", 0.05, 0.9), rowOf("a", "bin", 0.01, 0.2), rowOf("a", "bin", 0.02, 0.4)});
  EXPECT_EQ(three.objects, 3u);
  EXPECT_DOUBLE_EQ(three.chamfer_l1_m.value, 0.02);
  EXPECT_DOUBLE_EQ(three.center_error_m.value, 0.04);
  EXPECT_DOUBLE_EQ(three.v_iou.value, 0.4);
  const SingleViewSummary two =
      summaryOf({rowOf("a", "bin", 0.01, 0.2), rowOf("a", "bin", 0.03, 0.4)});
  EXPECT_DOUBLE_EQ(two.chamfer_l1_m.value, 0.02);
  EXPECT_DOUBLE_EQ(two.v_iou.value, 0.3);
}

TEST(SingleViewSummary, AnObjectWithoutAnEstimateIsInfinitelyBad) {
  const SingleViewRow good = rowOf("a", "bin", 0.01, 0.8);
  const SingleViewRow fair = rowOf("a", "bin", 0.03, 0.6);
  const SingleViewRow none = failureOf("a", "bin");
  EXPECT_DOUBLE_EQ(summaryOf({good, fair, none}).chamfer_l1_m.value, 0.03);
  EXPECT_DOUBLE_EQ(summaryOf({good, fair, none}).v_iou.value, 0.6);
  EXPECT_DOUBLE_EQ(summaryOf({good, fair, none}).failure_share.value, 1.0 / 3);
  // With half of them gone there is no number in the middle.
  EXPECT_TRUE(std::isinf(summaryOf({good, none}).chamfer_l1_m.value));
  EXPECT_DOUBLE_EQ(summaryOf({good, none}).v_iou.value, 0.4);
  EXPECT_EQ(summaryOf({none}).v_iou.value, 0);
}

TEST(SingleViewSummary, IntervalsSpanWhatResamplesGive) {
  const SingleViewRow good = rowOf("a", "bin", 0.01, 0.8);
  const SingleViewRow bad = rowOf("a", "bin", 0.40, 0.0);
  // All alike: no spread.
  const SingleViewSummary sure = summaryOf({good, good, good}, 200);
  EXPECT_EQ(sure.chamfer_l1_m.interval, (Interval{0.01, 0.01}));
  EXPECT_EQ(sure.failure_share.interval, (Interval{0, 0}));
  // One of two: a resample is both good, both bad or mixed, each often.
  const SingleViewSummary unsure = summaryOf({good, bad}, 200);
  EXPECT_EQ(unsure.chamfer_l1_m.interval, (Interval{0.01, 0.40}));
  EXPECT_EQ(unsure.failure_share.interval, (Interval{0, 1}));
  EXPECT_DOUBLE_EQ(unsure.failure_share.value, 0.5);
  EXPECT_EQ(summaryOf({good, bad}, 200).v_iou.interval, unsure.v_iou.interval);
  EXPECT_EQ(summaryOf({good, bad}, 0).failure_share.interval, (Interval{0.5, 0.5}));
}

TEST(SingleViewSummary, GroupsByEstimatorInOrderAndByClass) {
  const auto summaries =
      summarize({rowOf("second", "chair", 0.02, 0.5, 30), rowOf("first", "bin", 0.04, 0.5),
                 rowOf("second", "bin", 0.06, 0.5, 10), rowOf("second", "bin", 0.08, 0.5, 20)},
                {.resamples = 0});
  std::vector<std::string> names;
  for (const SingleViewSummary& s : summaries) {
    names.push_back(s.estimator + " " + s.class_name + " " + std::to_string(s.objects));
  }
  EXPECT_THAT(names, ::testing::ElementsAre("second all 3", "second bin 2", "second chair 1",
                                            "first all 1", "first bin 1"));
  EXPECT_DOUBLE_EQ(summaries[0].chamfer_l1_m.value, 0.06);
  EXPECT_EQ(summaries[0].p50_ms.value(), 20);
  EXPECT_EQ(summaries[0].p99_ms.value(), 30);
}

TEST(SingleViewSummary, KeepsDatasetsApartAndDomains) {
  SingleViewRow trained = rowOf("a", "chair", 0.01, 0.5);
  SingleViewRow other = rowOf("a", "computer", 0.09, 0.5);
  trained.in_domain = true;
  other.in_domain = false;
  SingleViewRow elsewhere = trained;
  elsewhere.dataset = "campus";
  std::vector<std::string> names;
  const auto summaries = summarize({trained, other, trained, elsewhere}, {.resamples = 0});
  for (const SingleViewSummary& s : summaries) {
    names.push_back(s.dataset + " " + s.class_name + " " + std::to_string(s.objects));
  }
  EXPECT_THAT(names,
              ::testing::ElementsAre("office all 3", "office in_domain 2", "office out_of_domain 1",
                                     "office chair 2", "office computer 1", "campus all 1",
                                     "campus in_domain 1", "campus chair 1"));
  EXPECT_DOUBLE_EQ(summaries[2].chamfer_l1_m.value, 0.09);
}

TEST(SingleViewTables, ViewsHaveAColumnPerStage) {
  SingleViewRow row = rowOf("a", "bin", 0.01, 0.75, 12);
  row.wall_ms["network"] = 7.5;
  const std::vector<std::string> lines = linesOf(viewsCsv({row, failureOf("a", "bin")}));
  ASSERT_EQ(lines.size(), 3u);
  EXPECT_EQ(lines[0],
            "dataset,seed,estimator,object,class,in_domain,subtype,stamp_ns,pixels,distance_m,cut,"
            "seen_fraction,failure,failed,chamfer_l1_m,center_error_m,v_iou,b_iou,inlier_ratio,"
            "network_wall_ms,total_wall_ms");
  EXPECT_THAT(lines[1], ::testing::StartsWith("office,1,a,bin_000,bin,,,0,0,0,0,0,,0,0.01,"));
  EXPECT_THAT(lines[1], ::testing::EndsWith(",7.5,12"));
  EXPECT_THAT(lines[2], HasSubstr(",too few points,1,"));
  EXPECT_THAT(lines[2], ::testing::EndsWith(",,10"));  // no time of the network
  for (const std::string& line : lines) {
    EXPECT_EQ(std::count(line.begin(), line.end(), ','), 20) << line;
  }
}

TEST(SingleViewTables, SummariesAreWrittenWithIntervalsAndInfinity) {
  const auto summaries = summarize({failureOf("a", "bin")}, {.resamples = 0});
  const std::vector<std::string> lines = linesOf(summaryCsv(summaries));
  ASSERT_EQ(lines.size(), 3u);
  EXPECT_EQ(lines[0],
            "dataset,estimator,class,objects,chamfer_l1_m,chamfer_l1_m_low,chamfer_l1_m_high,"
            "center_error_m,center_error_m_low,center_error_m_high,v_iou,v_iou_low,v_iou_high,"
            "b_iou,b_iou_low,b_iou_high,failures,failures_low,failures_high,p50_ms,p99_ms");
  EXPECT_EQ(lines[1], "office,a,all,1,inf,inf,inf,inf,inf,inf,0,0,0,0,0,0,1,1,1,,");
  EXPECT_THAT(summaryTable(summaries), HasSubstr("inf (inf-inf)"));
  EXPECT_THAT(summaryTable(summaries), HasSubstr("n/a"));  // no time of a shape
  EXPECT_EQ(linesOf(summaryTable(summaries)).size(), 3u);
}

}  // namespace
}  // namespace hydrabench

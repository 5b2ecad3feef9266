// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/report/sweep_report.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/temporary_folder.h"

namespace hydrabench {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::SizeIs;

ScoreRow row(const std::string& method, const std::string& metric, double value,
             const std::string& seed = "1") {
  ScoreRow result;
  result.dataset = "office";
  result.seed = seed;
  result.method = method;
  result.class_name = kAllMicro;
  result.threshold_kind = "tau_m";
  result.threshold = 0.2;
  result.matching = kMatchingExists;
  result.metric = metric;
  result.value = value;
  return result;
}

/// Two methods at three voxel sizes, given in no order.
SweepScores sweep() {
  SweepScores result;
  result.axes = {{"voxel_m", "voxel size [m]"}};
  result.points = {{{"0.2"}, {row("hydra", "f1", 0.5), row("khronos", "f1", 0.3)}},
                   {{"0.05"}, {row("hydra", "f1", 0.8), row("khronos", "f1", 0.6)}},
                   {{"0.1"}, {row("hydra", "f1", 0.7), row("khronos", "f1", 0.4)}}};
  return result;
}

TEST(SweepReport, PutsTheAxesInFrontOfTheScores) {
  const std::string text = sweepCsv(sweep());
  EXPECT_THAT(text, ::testing::StartsWith("voxel_m,dataset,seed,method,"));
  EXPECT_THAT(text, HasSubstr("\n0.05,office,1,hydra,"));
}

TEST(SweepReport, IsReadBackAsItWasWritten) {
  const TemporaryFolder folder;
  writeText(folder / "scores.csv", sweepCsv(sweep()));
  const auto back = readSweepCsv(folder / "scores.csv");
  ASSERT_TRUE(back);
  EXPECT_EQ(back->axes[0].name, "voxel_m");
  EXPECT_EQ(sweepCsv(*back), sweepCsv(sweep()));
  // The scores of a single experiment are no sweep.
  writeText(folder / "scores.csv", scoresCsv({row("hydra", "f1", 0.5)}));
  EXPECT_FALSE(readSweepCsv(folder / "scores.csv"));
}

TEST(SweepReport, HasARowForEveryMethodAndPoint) {
  const ComparisonTable table = sweepTable(sweep());
  ASSERT_THAT(table.blocks, SizeIs(1));
  ASSERT_THAT(table.blocks[0].rows, SizeIs(6));
  EXPECT_EQ(table.blocks[0].rows[0].label, "Hydra, voxel_m 0.2");
}

TEST(SweepReport, PlotsACurveForEveryMethodOverTheAxis) {
  const Plot plot = sweepPlot(sweep(), "office", kMatchingExists);
  ASSERT_THAT(plot.panels, SizeIs(2));
  const PlotPanel& f1 = plot.panels[0];
  EXPECT_EQ(f1.x_label, "voxel size [m]");
  EXPECT_EQ(f1.x_range, Eigen::Vector2d(0.05, 0.2));
  ASSERT_THAT(f1.curves, SizeIs(2));
  EXPECT_EQ(f1.curves[1].label, "Khronos");
  EXPECT_EQ(f1.curves[1].points,
            (std::vector<Eigen::Vector2d>{{0.05, 0.6}, {0.1, 0.4}, {0.2, 0.3}}));
}

TEST(SweepReport, MoreAxesAreMoreCurves) {
  SweepScores two = sweep();
  two.axes.push_back({"drift", "drift"});
  for (std::size_t i = 0; i < two.points.size(); ++i) {
    two.points[i].values.push_back(i == 0 ? "0" : "0.1");
  }
  const Plot plot = sweepPlot(two, "office", kMatchingExists);
  EXPECT_THAT(plot.panels[0].curves, SizeIs(4));
  EXPECT_EQ(plot.panels[0].curves[0].label, "Hydra, drift 0");
}

TEST(SweepReport, WordsStandInTheirOrder) {
  SweepScores words = sweep();
  for (std::size_t i = 0; i < words.points.size(); ++i) {
    words.points[i].values = {std::vector<std::string>{"clean", "default", "hard"}[i]};
  }
  const Plot plot = sweepPlot(words, "office", kMatchingExists);
  EXPECT_EQ(plot.panels[0].curves[0].points,
            (std::vector<Eigen::Vector2d>{{1, 0.5}, {2, 0.8}, {3, 0.7}}));
}

TEST(SweepReport, TakesThePooledRowsWhereThereAreSome) {
  SweepScores pooled = sweep();
  for (SweepScores::Point& point : pooled.points) {
    point.rows.push_back(row("hydra", "f1", 0.9, kPooledSeed));
  }
  const Plot plot = sweepPlot(pooled, "office", kMatchingExists);
  ASSERT_THAT(plot.panels[0].curves, SizeIs(1));
  EXPECT_EQ(plot.panels[0].curves[0].points[0].y(), 0.9);
  EXPECT_THAT(sweepDatasets(pooled), ElementsAre("office"));
}

}  // namespace
}  // namespace hydrabench

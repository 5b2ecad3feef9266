// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/experiment/latency_table.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace hydrabench {
namespace {

using ::testing::HasSubstr;

SingleViewRow call(const std::string& dataset, const std::string& estimator, double network_ms,
                   double total_ms) {
  SingleViewRow row;
  row.dataset = dataset;
  row.estimator = estimator;
  row.wall_ms = {{"network", network_ms}, {"total", total_ms}};
  return row;
}

SingleViewRow failedCall(const std::string& estimator, const std::string& why) {
  SingleViewRow row = call("office", estimator, 1, 1);
  row.failure = why;
  return row;
}

/// Four shapes of one estimator and a failure, none of another, and one shape elsewhere.
std::vector<SingleViewRow> someCalls() {
  return {call("office", "crisp", 10, 20),
          call("office", "crisp", 20, 40),
          failedCall("crisp", "no pose"),
          call("office", "crisp", 30, 60),
          call("office", "crisp", 60, 100),
          failedCall("sam3d", "the sidecar did not start"),
          failedCall("sam3d", "the sidecar was given up"),
          failedCall("sam3d", "the sidecar was given up"),
          call("campus", "crisp", 5, 500)};
}

TEST(LatencyTable, CountsTheCallsThatGaveAShape) {
  const std::vector<LatencyRow> rows = latencyRows(someCalls());
  ASSERT_EQ(rows.size(), 5u);
  EXPECT_EQ(rows[0].stage, "total");
  EXPECT_EQ(rows[0].objects, 5u);
  EXPECT_EQ(rows[0].times.n, 4u);
  EXPECT_DOUBLE_EQ(rows[0].times.mean_ms, 55);  // (20 + 40 + 60 + 100) / 4
  EXPECT_EQ(rows[0].times.p50_ms, 40);          // nearest rank: the second of four
  EXPECT_EQ(rows[0].times.p90_ms, 100);
  EXPECT_EQ(rows[0].note, "1 of 5 without a shape: no pose");
  EXPECT_EQ(rows[1].stage, "network");
  EXPECT_DOUBLE_EQ(rows[1].times.mean_ms, 30);
  EXPECT_EQ(rows[3].dataset, "campus");
}

TEST(LatencyTable, SaysWhyAnEstimatorIsNotAvailable) {
  const std::vector<LatencyRow> rows = latencyRows(someCalls());
  EXPECT_EQ(rows[2].estimator, "sam3d");
  EXPECT_EQ(rows[2].times.n, 0u);
  EXPECT_THAT(latencyMarkdown(rows), HasSubstr("| office | sam3d | total | 0 | n/a | n/a | n/a | "
                                               "n/a | n/a | not available: the sidecar did not "
                                               "start |"));
  EXPECT_THAT(
      latencyCsv(rows),
      HasSubstr("\noffice,sam3d,total,3,0,,,,,,not available: the sidecar did not start\n"));
  EXPECT_THAT(latencyCsv(rows),
              HasSubstr("\noffice,crisp,network,5,4,30.000,20.000,60.000,60.000,60.000,\n"));
}

TEST(LatencyTable, PlotsAViolinForEachEstimatorInAPanelForEachDataset) {
  const Plot plot = latencyPlot(someCalls());
  ASSERT_EQ(plot.panels.size(), 2u);
  ASSERT_EQ(plot.panels[0].violins.size(), 2u);
  EXPECT_EQ(plot.panels[0].violins[0].values, (std::vector<double>{20, 40, 60, 100}));
  EXPECT_TRUE(plot.panels[0].violins[1].values.empty());
  EXPECT_EQ(plot.panels[1].y_range, Eigen::Vector2d(10, 1000));  // whole decades, of all panels
  EXPECT_TRUE(latencyPlot({failedCall("sam3d", "none")}).panels.empty());
}

}  // namespace
}  // namespace hydrabench

// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/report/kappa_report.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "eval/evaluation/score_row.h"

namespace hydrabench {
namespace {

using ::testing::HasSubstr;

/// One class, 2 truths; the estimates become right at the given kappas.
MethodEvaluation method(const std::string& name, const std::string& seed,
                        std::vector<double> kappas) {
  MethodEvaluation evaluation;
  evaluation.dataset = "office";
  evaluation.seed = seed;
  evaluation.method = name;
  for (const char* class_name : {kAllMicro, "chair"}) {
    for (const Matching matching : {Matching::kExists, Matching::kOneToOne}) {
      KappaSweep sweep;
      sweep.matching = matching;
      sweep.steps.push_back({0, {kappas.size(), 0, 2, 0}});
      for (std::size_t i = 0; i < kappas.size(); ++i) {
        sweep.steps.push_back({kappas[i], {kappas.size(), i + 1, 2, i + 1}});
      }
      evaluation.kappa_curves.push_back({class_name, sweep});
    }
  }
  return evaluation;
}

TEST(KappaReport, TakesThePooledWorldsWhereThereAreSome) {
  const std::vector<MethodEvaluation> evaluations = {
      method("a", "1", {0.5}), method("a", "2", {0.5}), method("a", kPooledSeed, {0.5})};
  const auto reports = kappaReports(evaluations, 1);
  ASSERT_EQ(reports.size(), 2u);  // one per matching
  ASSERT_EQ(reports[0].methods.size(), 1u);
  EXPECT_EQ(reports[0].methods[0]->seed, kPooledSeed);
}

TEST(KappaReport, SaysOnWhichShareOfKappaOneMethodIsAboveAnother) {
  // a is right from 0.25 on, b from 0.5 on: a is above b on (0.25, 0.5].
  const std::vector<MethodEvaluation> evaluations = {method("a", "1", {0.25}),
                                                     method("b", "1", {0.5})};
  const KappaReport report = kappaReports(evaluations, 1).front();
  EXPECT_DOUBLE_EQ(report.shareAbove(0, 1), 0.25);
  EXPECT_DOUBLE_EQ(report.shareAbove(1, 0), 0);
  EXPECT_DOUBLE_EQ(kappaReports(evaluations, 0.3).front().shareAbove(0, 1), 0.05 / 0.3);
}

TEST(KappaReport, PrintsMeansOverKappa) {
  // P = 1 on (0.25, 1], R = 1/2 there, F1 = 2/3: means 0.750, 0.375, 0.500.
  const std::vector<MethodEvaluation> evaluations = {method("a", "1", {0.25})};
  EXPECT_THAT(kappaMarkdown(kappaReports(evaluations, 1)),
              HasSubstr("| a | 0.750 | 0.375 | 0.500 |"));
}

TEST(KappaReport, PlotsExactStepsWithIntervals) {
  const std::vector<MethodEvaluation> evaluations = {method("a", "1", {0.25})};
  EvaluationConfig config;
  config.bootstrap_resamples = 50;
  const Plot plot = kappaPlot(kappaReports(evaluations, 1).front(), config);
  ASSERT_EQ(plot.panels.size(), 3u);
  const PlotCurve& recall = plot.panels[1].curves.front();
  EXPECT_EQ(recall.points, (std::vector<Eigen::Vector2d>{{0, 0}, {0.25, 0.5}}));
  EXPECT_EQ(recall.band.size(), 41u);
  EXPECT_THAT(recall.label, HasSubstr("AUC 0.50"));
}

TEST(KappaReport, LeavesIntervalsEmptyWithoutResamples) {
  const std::vector<MethodEvaluation> evaluations = {method("a", "1", {0.25})};
  EvaluationConfig config;
  config.bootstrap_resamples = 0;
  EXPECT_THAT(kappaIntervalsCsv(kappaReports(evaluations, 1), config),
              HasSubstr("office,1,a,exists,1,1,,,0.5,,,0.6666666666666666,,\n"));
}

}  // namespace
}  // namespace hydrabench

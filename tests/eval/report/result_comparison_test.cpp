// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/report/result_comparison.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/types/error.h"
#include "eval/evaluation/method_scores.h"
#include "eval/experiment/frame_times.h"
#include "eval/report/objects_csv.h"
#include "tests/support/temporary_folder.h"

namespace hydrabench {
namespace {

using ::testing::HasSubstr;
using ::testing::SizeIs;
using Verdict = ResultComparison::Verdict;

EvaluationConfig config() {
  EvaluationConfig result;
  result.thresholds_m = {0.2};
  result.kappas = {};
  result.bootstrap_resamples = 0;
  return result;
}

ScoredObject object(std::size_t i) {
  ScoredObject result;
  result.detection = {i + 1, 5, {2.0 * static_cast<double>(i), 0.1, 0}, 0.5};
  result.class_name = "chair";
  result.faces = 12;
  result.has_surface = true;
  result.visible_fraction = 0.25;
  return result;
}

/// Forty chairs of which the method finds the first `found`, with this box IoU.
MethodEvaluation finder(std::size_t found, double b_iou, const std::string& seed = "1") {
  MethodEvaluation evaluation;
  evaluation.dataset = "office";
  evaluation.seed = seed;
  evaluation.method = "hydra";
  evaluation.label_space = {{{5, "chair", {}, true, true}}};
  for (std::size_t i = 0; i < 40; ++i) {
    evaluation.truths.push_back(object(i));
    if (i >= found) continue;
    PairScores scores;
    scores.b_iou = b_iou + 0.001 * static_cast<double>(i % 7);
    scores.v_iou_solid = 0.5;
    scores.chamfer_l1 = 0.02;
    evaluation.pair_scores[{i, i}] = scores;
    evaluation.estimates.push_back(object(i));
  }
  rescore(config(), evaluation);
  return evaluation;
}

constexpr const char* kTime = "time per frame [ms]";

class CompareResults : public ::testing::Test {
 protected:
  double other_work_ = 1;
  double yardstick_ms_ = 0.5;        ///< 0: not measured, as in older results
  double yardstick_under_work_ = 1;  ///< what the other work does to it

  void write(const std::string& name, const std::vector<MethodEvaluation>& evaluations,
             double frame_ms = 10, const std::string& cpu = "some cpu") {
    std::vector<ScoreRow> rows;
    for (const MethodEvaluation& evaluation : evaluations) {
      rows.insert(rows.end(), evaluation.scores.begin(), evaluation.scores.end());
    }
    writeText(folder_ / name / "scores.csv", scoresCsv(rows));
    writeText(folder_ / name / "objects.csv", objectsCsv(evaluations));
    // Frames take turns in being quick and slow; every tenth stretch of 25 hits other work.
    FrameTimes times{"office", "1", "hydra", {}, {}, {}};
    for (int i = 0; i < 500; ++i) {
      const double other_work = i / 25 % 10 == 0 ? other_work_ : 1;
      times.wall_ms.push_back(frame_ms * (1 + i % 3) / 2 * other_work);
      if (yardstick_ms_ == 0) continue;
      times.yardstick_ms.push_back(yardstick_ms_ * (other_work > 1 ? yardstick_under_work_ : 1));
    }
    writeText(folder_ / name / "frame_times.csv", frameTimesCsv({times}));
    writeText(folder_ / name / "provenance.json", "{\"cpu\": \"" + cpu + "\", \"cores\": 2}");
  }
  ResultComparison compare() { return compareResults(folder_ / "a", folder_ / "b", {}); }
  static const ResultComparison::Line& line(const ResultComparison& comparison,
                                            const std::string& metric) {
    for (const auto& candidate : comparison.lines) {
      if (candidate.metric == metric) return candidate;
    }
    throw std::runtime_error("no " + metric);
  }

  TemporaryFolder folder_;
};

TEST(ObjectsCsv, ReadsBackWhatIsNeededToCompareAgain) {
  const TemporaryFolder folder;
  const MethodEvaluation written = finder(30, 0.8);
  writeText(folder / "objects.csv", objectsCsv({written}));
  const std::vector<MethodEvaluation> read = readObjectsCsv(folder / "objects.csv");
  ASSERT_THAT(read, SizeIs(1));
  ASSERT_THAT(read[0].truths, SizeIs(40));
  ASSERT_THAT(read[0].estimates, SizeIs(30));
  EXPECT_EQ(read[0].truths[7].detection.id, written.truths[7].detection.id);
  EXPECT_EQ(read[0].truths[7].detection.center, written.truths[7].detection.center);
  EXPECT_EQ(read[0].truths[39].visible_fraction, 0.25);
  EXPECT_EQ(read[0].pair_scores, written.pair_scores);
}

TEST_F(CompareResults, AResultIsTheSameAsItself) {
  MethodEvaluation evaluation = finder(30, 0.8);
  evaluation.estimates.push_back(object(1000));  // a wrong one, drawn or not drawn
  rescore(config(), evaluation);
  write("a", {evaluation});
  write("b", {evaluation});
  const ResultComparison comparison = compare();
  ASSERT_THAT(comparison.lines, SizeIs(5));
  for (const auto& each : comparison.lines) EXPECT_EQ(each.verdict, Verdict::kSame) << each.metric;
  EXPECT_EQ(comparison.verdict(), Verdict::kSame);
}

TEST_F(CompareResults, FindingHalfOfItIsWorseAndTheOtherWayRoundBetter) {
  write("a", {finder(40, 0.8)});
  write("b", {finder(20, 0.8)});
  EXPECT_EQ(compare().verdict(), Verdict::kWorse);
  const auto f1 = line(compare(), "f1 (0.2 m)");
  EXPECT_DOUBLE_EQ(f1.before, 1);
  EXPECT_DOUBLE_EQ(f1.after, 2.0 / 3);
  EXPECT_LT(f1.high, 0);
  EXPECT_EQ(line(compare(), "chamfer_l1_all_gt (0.2 m)").verdict, Verdict::kWorse);
  const ResultComparison reverse = compareResults(folder_ / "b", folder_ / "a", {});
  EXPECT_EQ(line(reverse, "f1 (0.2 m)").verdict, Verdict::kBetter);
  EXPECT_EQ(reverse.verdict(), Verdict::kBetter);
}

TEST_F(CompareResults, OneObjectLessOfFortyIsTooLittleToSay) {
  write("a", {finder(30, 0.8)});
  write("b", {finder(29, 0.8)});
  EXPECT_EQ(line(compare(), "f1 (0.2 m)").verdict, Verdict::kInconclusive);
  EXPECT_EQ(compare().verdict(), Verdict::kInconclusive);
}

TEST_F(CompareResults, LessThanTheNoiseFloorIsNoDifference) {
  write("a", {finder(40, 0.8)});
  write("b", {finder(40, 0.798)});
  EXPECT_EQ(line(compare(), "b_iou_all_gt (0.2 m)").verdict, Verdict::kSame);
  NoiseFloor strict;
  strict.score = 0.001;
  EXPECT_EQ(
      line(compareResults(folder_ / "a", folder_ / "b", strict), "b_iou_all_gt (0.2 m)").verdict,
      Verdict::kWorse);
}

TEST_F(CompareResults, TimesAreComparedOnTheSameMachineOnly) {
  write("a", {finder(30, 0.8)}, 10);
  write("b", {finder(30, 0.8)}, 13);
  EXPECT_EQ(line(compare(), kTime).verdict, Verdict::kWorse);
  write("b", {finder(30, 0.8)}, 13, "another cpu");
  EXPECT_THAT(compare().lines, SizeIs(4));
  EXPECT_THAT(compare().notes, ::testing::ElementsAre(HasSubstr("other machines")));
}

TEST_F(CompareResults, FivePerCentSlowerIsSeenAndOnePerCentIsNot) {
  write("a", {finder(30, 0.8)}, 10);
  write("b", {finder(30, 0.8)}, 10.5);
  EXPECT_EQ(line(compare(), kTime).verdict, Verdict::kWorse);
  EXPECT_NEAR(line(compare(), kTime).after / line(compare(), kTime).before, 1.05, 1e-4);
  write("b", {finder(30, 0.8)}, 10.3);  // surely more than half of the floor
  EXPECT_EQ(line(compare(), kTime).verdict, Verdict::kWorse);
  write("b", {finder(30, 0.8)}, 10.1);
  EXPECT_EQ(line(compare(), kTime).verdict, Verdict::kSame);
  write("b", {finder(30, 0.8)}, 9.9);
  EXPECT_EQ(line(compare(), kTime).verdict, Verdict::kSame);
  write("b", {finder(30, 0.8)}, 9);
  EXPECT_EQ(line(compare(), kTime).verdict, Verdict::kBetter);
}

TEST_F(CompareResults, TimesOfADisturbedMachineAreInconclusive) {
  write("a", {finder(30, 0.8)}, 10);
  other_work_ = 2;
  write("b", {finder(30, 0.8)}, 10);
  EXPECT_EQ(line(compare(), kTime).verdict, Verdict::kInconclusive);
}

TEST_F(CompareResults, FivePerCentSlowerOnADisturbedMachineIsNotTheSame) {
  write("a", {finder(30, 0.8)}, 10);
  other_work_ = 1.5;
  write("b", {finder(30, 0.8)}, 10);
  write("c", {finder(30, 0.8)}, 10 * 1.05);
  const ResultComparison comparison = compareResults(folder_ / "b", folder_ / "c", {});
  EXPECT_NE(line(comparison, kTime).verdict, Verdict::kSame);
  EXPECT_EQ(line(compare(), kTime).verdict, Verdict::kInconclusive);
}

TEST_F(CompareResults, WhatSlowsTheYardstickAsMuchIsNotTheProgram) {
  write("a", {finder(30, 0.8)}, 10);
  other_work_ = yardstick_under_work_ = 2;
  write("b", {finder(30, 0.8)}, 10);
  EXPECT_EQ(line(compare(), kTime).verdict, Verdict::kSame);
  // A machine that is slower throughout.
  other_work_ = yardstick_under_work_ = 1;
  yardstick_ms_ = 0.6;
  write("b", {finder(30, 0.8)}, 12);
  EXPECT_EQ(line(compare(), kTime).verdict, Verdict::kSame);
  EXPECT_NEAR(line(compare(), kTime).after / line(compare(), kTime).before, 1.2, 1e-4);
  write("b", {finder(30, 0.8)}, 12 * 1.05);
  EXPECT_EQ(line(compare(), kTime).verdict, Verdict::kWorse);
}

TEST_F(CompareResults, ResultsWithoutAYardstickAreComparedByTheClock) {
  write("a", {finder(30, 0.8)}, 10);
  yardstick_ms_ = 0;
  write("b", {finder(30, 0.8)}, 12);
  EXPECT_EQ(line(compare(), kTime).verdict, Verdict::kWorse);
  writeText(folder_ / "b/frame_times.csv",
            "dataset,seed,method,frame,wall_ms\noffice,1,hydra,0,10\noffice,1,hydra,1,10\n");
  EXPECT_THAT(compare().notes, ::testing::ElementsAre(HasSubstr("500 frames before and 2 after")));
}

TEST_F(CompareResults, AFewFramesAreTooLittleToSay) {
  write("a", {finder(30, 0.8)}, 10);
  write("b", {finder(30, 0.8)}, 13);
  for (const auto& [name, frame_ms] : {std::pair{"a", 10.0}, std::pair{"b", 20.0}}) {
    const FrameTimes times{"office", "1", "hydra", std::vector<double>(7 * 25, frame_ms), {}, {}};
    writeText(folder_ / name / "frame_times.csv", frameTimesCsv({times}));
  }
  EXPECT_EQ(line(compare(), kTime).verdict, Verdict::kInconclusive);
}

TEST_F(CompareResults, InstructionsAreComparedOnAnyMachineAndInsteadOfTimes) {
  constexpr const char* kInstructions = "10^6 instructions per frame";
  const auto writeCounted = [&](const std::string& name, double millions, const std::string& cpu) {
    write(name, {finder(30, 0.8)}, 10, cpu);
    FrameTimes counted{"office", "1", "hydra", {}, {}, {}};
    for (int i = 0; i < 10; ++i) counted.instructions.push_back(millions * (1 + i % 3));
    writeText(folder_ / name / "frame_times.csv", frameTimesCsv({counted}));
  };
  writeCounted("a", 100, "some cpu");
  writeCounted("b", 100.01, "another cpu");
  EXPECT_EQ(line(compare(), kInstructions).verdict, Verdict::kSame);
  EXPECT_NEAR(line(compare(), kInstructions).before, 190, 1e-9);
  EXPECT_NEAR(line(compare(), kInstructions).high, 1e-4, 1e-9);
  EXPECT_THAT(compare().notes, SizeIs(0));
  writeCounted("b", 105, "some cpu");
  EXPECT_EQ(line(compare(), kInstructions).verdict, Verdict::kWorse);
  EXPECT_THAT(comparisonMarkdown(compare()), HasSubstr("+5.0 to +5.0 %"));
  EXPECT_THROW(line(compare(), kTime), std::runtime_error);
  writeCounted("b", 90, "some cpu");
  EXPECT_EQ(line(compare(), kInstructions).verdict, Verdict::kBetter);
  write("b", {finder(30, 0.8)}, 10);
  EXPECT_THAT(compare().notes, ::testing::ElementsAre(HasSubstr("timed in one result")));
}

TEST_F(CompareResults, OtherFramesAreNotCompared) {
  write("a", {finder(30, 0.8)}, 10);
  write("b", {finder(30, 0.8)}, 10);
  writeText(folder_ / "b/frame_times.csv",
            frameTimesCsv({{"office", "1", "hydra", {10, 10}, {}, {}}}));
  EXPECT_THAT(compare().notes, ::testing::ElementsAre(HasSubstr("500 frames before and 2 after")));
}

TEST_F(CompareResults, WorldsOfADatasetCountTogether) {
  write("a", {finder(40, 0.8, "1"), finder(40, 0.8, "2")});
  write("b", {finder(40, 0.8, "1"), finder(20, 0.8, "2")});
  EXPECT_DOUBLE_EQ(line(compare(), "f1 (0.2 m)").after, 2 * 0.75 / 1.75);
}

TEST_F(CompareResults, RefusesWhatCannotBeCompared) {
  write("a", {finder(30, 0.8)});
  EXPECT_THAT(messageOf<InputError>([&] { compare(); }), HasSubstr("no objects.csv in there"));
  MethodEvaluation other = finder(30, 0.8);
  other.truths[3].detection.center.x() += 0.5;
  rescore(config(), other);
  write("b", {other});
  EXPECT_THAT(messageOf<InputError>([&] { compare(); }), HasSubstr("ground truth differs"));
  MethodEvaluation khronos = finder(30, 0.8);
  khronos.method = "khronos";
  rescore(config(), khronos);
  write("b", {khronos});
  EXPECT_THAT(messageOf<InputError>([&] { compare(); }), HasSubstr("nothing to compare"));
}

TEST_F(CompareResults, SpeaksMarkdownAndJUnit) {
  write("a", {finder(40, 0.8)});
  write("b", {finder(20, 0.8)});
  EXPECT_THAT(comparisonMarkdown(compare()),
              HasSubstr("| office | Hydra | f1 (0.2 m) | 1 | 0.6667 |"));
  EXPECT_THAT(comparisonMarkdown(compare()), HasSubstr("**worse**"));
  const std::string junit = comparisonJUnit(compare());
  EXPECT_THAT(junit, HasSubstr("tests=\"5\" failures=\"4\" skipped=\"0\""));
  EXPECT_THAT(junit, HasSubstr("<failure message=\"1 -&gt; 0.6667"));
}

}  // namespace
}  // namespace hydrabench

// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/claims/verdict.h"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "core/types/error.h"
#include "eval/claims/claim_report.h"
#include "eval/evaluation/method_scores.h"
#include "eval/report/objects_csv.h"
#include "tests/support/temporary_folder.h"

namespace hydrabench {
namespace {

using ::testing::HasSubstr;
using ::testing::SizeIs;

constexpr std::size_t kTruths = 60;

/// Half diagonals spread by a factor of e around 0.5 m.
double sizeOf(std::size_t i) {
  return 0.5 * std::exp(static_cast<double>(i) / (kTruths - 1) - 0.5);
}

ScoredObject object(std::size_t i) {
  ScoredObject result;
  result.detection = {i + 1, 5, {3.0 * static_cast<double>(i), 0, 0}, sizeOf(i)};
  result.class_name = "chair";
  result.faces = 12;
  result.has_surface = true;
  return result;
}

/// Finds the truths from `first` on, `off_m` beside their centres, and makes up `inventions` more.
MethodEvaluation finder(const std::string& method, std::size_t first, double off_m = 0,
                        std::size_t inventions = 0) {
  MethodEvaluation evaluation;
  evaluation.dataset = "office";
  evaluation.seed = "1";
  evaluation.method = method;
  for (std::size_t i = 0; i < kTruths; ++i) evaluation.truths.push_back(object(i));
  for (std::size_t i = first; i < kTruths; ++i) {
    PairScores scores;
    scores.b_iou = 0.8 + 0.001 * static_cast<double>(i % 5);
    scores.chamfer_l1 = 0.02 + 0.0001 * static_cast<double>(i % 5);
    evaluation.pair_scores[{evaluation.estimates.size(), i}] = scores;
    evaluation.estimates.push_back(object(i));
    evaluation.estimates.back().detection.center.y() = off_m;
  }
  for (std::size_t i = 0; i < inventions; ++i) {
    evaluation.estimates.push_back(object(i));
    evaluation.estimates.back().detection.id = 1000 + i;
    evaluation.estimates.back().detection.center.y() = 50;
  }
  return evaluation;
}

Evidence evidenceOf(std::vector<MethodEvaluation> methods) {
  Evidence evidence;
  evidence.result = "result";
  evidence.dataset = "office";
  evidence.num_worlds = 1;
  for (MethodEvaluation& method : methods) {
    evidence.methods.emplace(method.method, std::move(method));
  }
  return evidence;
}

Predicate need(Predicate::Type type, const std::string& metric,
               const std::vector<std::string>& than) {
  Predicate predicate;
  predicate.type = type;
  predicate.metric = metric;
  predicate.method = "ours";
  predicate.than = than;
  return predicate;
}

JudgedClaim judgeOne(const std::vector<Predicate>& needs, const std::vector<Evidence>& evidence) {
  Claim claim;
  claim.name = "it";
  claim.says = "it is so";
  claim.needs = needs;
  return judge({claim}, evidence, {500, 0.95, 0}).front();
}

ClaimVerdict verdictOf(const Predicate& predicate, const Evidence& evidence) {
  return judgeOne({predicate}, {evidence}).verdict;
}

TEST(Judge, ASureLeadHoldsAndItsContraryFails) {
  const Evidence evidence = evidenceOf({finder("ours", 0), finder("theirs", 40)});
  const Predicate better = need(Predicate::Type::kScore, "recall", {"theirs"});
  EXPECT_EQ(verdictOf(better, evidence), ClaimVerdict::kHolds);
  Predicate contrary = better;
  contrary.method = "theirs";
  contrary.than = {"ours"};
  EXPECT_EQ(verdictOf(contrary, evidence), ClaimVerdict::kFails);
  const Finding finding = judgeOne({better}, {evidence}).findings.front();
  EXPECT_NEAR(*finding.difference, 40.0 / 60, 1e-12);
  EXPECT_THAT(finding.what, HasSubstr("recall at 0.2 m, exists: ours 1.000, theirs 0.333"));
}

TEST(Judge, ASmallLeadIsUndecided) {
  const Evidence evidence = evidenceOf({finder("ours", 0), finder("theirs", 1)});
  EXPECT_EQ(verdictOf(need(Predicate::Type::kScore, "recall", {"theirs"}), evidence),
            ClaimVerdict::kUndecided);
}

TEST(Judge, AMarginIsWhatMayBeLost) {
  const Evidence evidence = evidenceOf({finder("ours", 12), finder("theirs", 0)});  // 0.2 lower
  Predicate no_worse = need(Predicate::Type::kScore, "recall", {"theirs"});
  no_worse.strictly = false;
  no_worse.margin = 0.5;
  EXPECT_EQ(verdictOf(no_worse, evidence), ClaimVerdict::kHolds);
  no_worse.margin = 0.2;
  EXPECT_EQ(verdictOf(no_worse, evidence), ClaimVerdict::kUndecided);
  no_worse.margin = 0.05;
  EXPECT_EQ(verdictOf(no_worse, evidence), ClaimVerdict::kFails);
}

TEST(Judge, EqualIsNoWorseButNotBetter) {
  const Evidence evidence = evidenceOf({finder("ours", 5), finder("theirs", 5)});
  Predicate predicate = need(Predicate::Type::kScore, "f1", {"theirs"});
  EXPECT_EQ(verdictOf(predicate, evidence), ClaimVerdict::kFails);
  predicate.strictly = false;
  EXPECT_EQ(verdictOf(predicate, evidence), ClaimVerdict::kHolds);
}

TEST(Judge, OfADistanceLessIsBetter) {
  MethodEvaluation coarse = finder("theirs", 0);
  for (auto& [pair, scores] : coarse.pair_scores) *scores.chamfer_l1 += 0.05;
  const Evidence evidence = evidenceOf({finder("ours", 30), coarse});
  Predicate predicate = need(Predicate::Type::kScore, "chamfer_l1", {"theirs"});
  predicate.matching = Matching::kOneToOne;
  const Finding finding = judgeOne({predicate}, {evidence}).findings.front();
  EXPECT_EQ(finding.verdict, ClaimVerdict::kHolds);
  EXPECT_NEAR(*finding.difference, 0.05, 1e-9);  // in favour of ours, each over what it found
}

TEST(Judge, MeansOverAFewFoundObjectsAreUndecided) {
  MethodEvaluation coarse = finder("theirs", 0);
  for (auto& [pair, scores] : coarse.pair_scores) *scores.chamfer_l1 += 0.05;
  Predicate predicate = need(Predicate::Type::kScore, "chamfer_l1", {"theirs"});
  predicate.matching = Matching::kOneToOne;
  EXPECT_EQ(verdictOf(predicate, evidenceOf({finder("ours", kTruths - 8), coarse})),
            ClaimVerdict::kHolds);
  const Finding finding =
      judgeOne({predicate}, {evidenceOf({finder("ours", kTruths - 7), coarse})}).findings.front();
  EXPECT_EQ(finding.verdict, ClaimVerdict::kUndecided);
  EXPECT_THAT(finding.what, HasSubstr("only 7 found"));
}

TEST(Judge, AResultWithoutABaselineTakesNothingFromOneThatHasIt) {
  const Predicate both = need(Predicate::Type::kScore, "recall", {"theirs", "others"});
  const Evidence full = evidenceOf({finder("ours", 0), finder("theirs", 40), finder("others", 30)});
  const Evidence part = evidenceOf({finder("ours", 0), finder("theirs", 40)});
  EXPECT_EQ(judgeOne({both}, {full, part}).verdict, ClaimVerdict::kHolds);
  EXPECT_THAT(judgeOne({both}, {full, part}).findings, SizeIs(3));
  const JudgedClaim judged = judgeOne({both}, {part});
  EXPECT_EQ(judged.verdict, ClaimVerdict::kNotRun);
  EXPECT_THAT(judged.findings.back().what, HasSubstr("no result with ours and others"));
}

TEST(Judge, AtAThresholdWithoutScoresNothingIsSaid) {
  MethodEvaluation unscored = finder("theirs", 0);
  unscored.pair_scores.clear();
  const Evidence evidence = evidenceOf({finder("ours", 0), unscored});
  Predicate predicate = need(Predicate::Type::kScore, "b_iou", {"theirs"});
  predicate.matching = Matching::kOneToOne;
  EXPECT_EQ(verdictOf(predicate, evidence), ClaimVerdict::kNotRun);
}

TEST(Judge, OverKappaEveryThresholdCounts) {
  // 5 mm beside the centre is inside the gate of every object at the smallest kappa, 2 cm are not.
  const Evidence evidence = evidenceOf(
      {finder("ours", 0, 0.005), finder("inventive", 0, 0.005, 30), finder("coarse", 0, 0.02)});
  EXPECT_EQ(verdictOf(need(Predicate::Type::kKappa, "precision", {"inventive"}), evidence),
            ClaimVerdict::kHolds);
  EXPECT_EQ(verdictOf(need(Predicate::Type::kKappa, "recall", {"inventive"}), evidence),
            ClaimVerdict::kFails);  // the same everywhere
  Predicate no_worse = need(Predicate::Type::kKappa, "recall", {"ours"});
  no_worse.method = "coarse";
  no_worse.strictly = false;
  const JudgedClaim judged = judgeOne({no_worse}, {evidence});
  EXPECT_EQ(judged.verdict, ClaimVerdict::kFails);
  EXPECT_THAT(judged.findings.front().what, HasSubstr("least at kappa 0.025"));
}

TEST(Judge, ATrendIsASlopeOverTheDeviationFromTheClass) {
  MethodEvaluation rigid = finder("ours", 0);
  for (auto& [pair, scores] : rigid.pair_scores) {
    const double deviation = std::abs(std::log(sizeOf(pair.truth) / 0.5));
    scores.chamfer_l1 = 0.02 + 0.3 * deviation + 0.001 * static_cast<double>(pair.truth % 3);
  }
  const Evidence evidence = evidenceOf({rigid, finder("theirs", 0)});
  const JudgedClaim grows = judgeOne({need(Predicate::Type::kTrend, "chamfer_l1", {}),
                                      need(Predicate::Type::kTrend, "chamfer_l1", {"theirs"})},
                                     {evidence});
  EXPECT_EQ(grows.verdict, ClaimVerdict::kHolds);
  EXPECT_NEAR(*grows.findings[0].difference, 0.3, 0.002);
  Predicate contrary = need(Predicate::Type::kTrend, "chamfer_l1", {"ours"});
  contrary.method = "theirs";
  EXPECT_EQ(verdictOf(contrary, evidence), ClaimVerdict::kFails);
}

TEST(Judge, RealTimeIsAllWorkWithinTheRecording) {
  const auto timed = [](std::vector<double> frame_ms) {
    Evidence evidence;
    for (std::size_t i = 0; i < frame_ms.size(); ++i) {
      const std::string seed = std::to_string(i);
      evidence.timing.push_back(
          {"office", seed, "ours", "frame", 100, frame_ms[i], 0, 0, 0, 0, 0, 0});
      evidence.timing.push_back({"office", seed, "ours", "finish", 1, 1000, 0, 0, 0, 0, 0, 0});
      evidence.timing.push_back({"office", seed, "ours", "mesh", 100, 500, 0, 0, 0, 0, 0, 0});
    }
    return evidence;
  };
  Predicate predicate = need(Predicate::Type::kRealTime, "", {});
  // 100 frames at 10 Hz last 10 s: 9 s of frames and 1 s at the end just fit.
  EXPECT_EQ(verdictOf(predicate, timed({90})), ClaimVerdict::kHolds);
  EXPECT_EQ(verdictOf(predicate, timed({91})), ClaimVerdict::kFails);
  EXPECT_EQ(verdictOf(predicate, timed({80, 99})), ClaimVerdict::kUndecided);
  predicate.keeps = false;
  EXPECT_EQ(verdictOf(predicate, timed({91})), ClaimVerdict::kHolds);
  EXPECT_EQ(verdictOf(predicate, Evidence{}), ClaimVerdict::kNotRun);
}

TEST(Judge, SceneScoresAreComparedByTheirIntervals) {
  Evidence evidence;
  const auto row = [](const std::string& method, double value, double margin) {
    ScoreRow result;
    result.method = method;
    result.metric = "ground_hole_area_m2";
    result.value = value;
    result.ci95_low = value - margin;
    result.ci95_high = value + margin;
    return result;
  };
  evidence.scores = {row("ours", 10, 2), row("theirs", 20, 7)};
  Predicate predicate = need(Predicate::Type::kScene, "ground_hole_area_m2", {"theirs"});
  predicate.lower_is_better = true;
  EXPECT_EQ(verdictOf(predicate, evidence), ClaimVerdict::kHolds);
  evidence.scores[1].ci95_low = 11;
  EXPECT_EQ(verdictOf(predicate, evidence), ClaimVerdict::kUndecided);
  evidence.scores[1].ci95_low.reset();
  EXPECT_EQ(verdictOf(predicate, evidence), ClaimVerdict::kUndecided);
  evidence.scores.push_back(row("ours", 11, 2));  // which of the two?
  EXPECT_EQ(verdictOf(predicate, evidence), ClaimVerdict::kNotRun);
  for (ScoreRow pooled : {row("ours", 10, 2), row("theirs", 20, 7)}) {
    pooled.seed = kPooledSeed;  // then those of all worlds together
    evidence.scores.push_back(pooled);
  }
  EXPECT_EQ(verdictOf(predicate, evidence), ClaimVerdict::kHolds);
  predicate.metric = "other";
  EXPECT_EQ(verdictOf(predicate, evidence), ClaimVerdict::kNotRun);
}

TEST(Judge, TheGravestFindingIsTheVerdict) {
  const Evidence evidence =
      evidenceOf({finder("ours", 0), finder("theirs", 40), finder("near", 1)});
  const Predicate sure = need(Predicate::Type::kScore, "recall", {"theirs"});
  const Predicate open = need(Predicate::Type::kScore, "recall", {"near"});
  const Predicate absent = need(Predicate::Type::kScore, "recall", {"nobody"});
  Predicate wrong = need(Predicate::Type::kScore, "recall", {"ours"});
  wrong.method = "theirs";
  EXPECT_EQ(judgeOne({sure, open}, {evidence}).verdict, ClaimVerdict::kUndecided);
  EXPECT_EQ(judgeOne({sure, open, absent}, {evidence}).verdict, ClaimVerdict::kNotRun);
  EXPECT_EQ(judgeOne({sure, open, absent, wrong}, {evidence}).verdict, ClaimVerdict::kFails);
  EXPECT_THAT(judgeOne({absent}, {evidence}).findings.front().what,
              HasSubstr("no result with ours and nobody"));
}

TEST(ReadEvidence, PutsTheWorldsOfADatasetTogether) {
  EvaluationConfig config;
  config.thresholds_m = {0.2};
  config.kappas = {};
  config.bootstrap_resamples = 0;
  std::vector<MethodEvaluation> evaluations;
  for (const char* seed : {"2", "10"}) {
    for (MethodEvaluation evaluation : {finder("ours", 0), finder("theirs", 40)}) {
      evaluation.seed = seed;
      evaluation.label_space = {{{5, "chair", {}, true, true}}};
      rescore(config, evaluation);
      evaluations.push_back(std::move(evaluation));
    }
  }
  evaluations.pop_back();  // theirs is on one world only
  std::vector<ScoreRow> rows;
  for (const MethodEvaluation& evaluation : evaluations) {
    rows.insert(rows.end(), evaluation.scores.begin(), evaluation.scores.end());
  }
  TemporaryFolder folder;
  writeText(folder / "scores.csv", scoresCsv(rows));
  writeText(folder / "objects.csv", objectsCsv(evaluations));
  const std::vector<Evidence> all = readEvidence({folder.path()});
  ASSERT_THAT(all, SizeIs(1));
  EXPECT_EQ(all[0].num_worlds, 2);
  ASSERT_THAT(all[0].methods, SizeIs(1));
  EXPECT_THAT(all[0].methods.at("ours").truths, SizeIs(2 * kTruths));
  EXPECT_THROW(readEvidence({folder / "nowhere"}), InputError);
}

TEST(ClaimReport, SaysVerdictAndNumbersInEveryFormat) {
  const Evidence evidence = evidenceOf({finder("ours", 0), finder("theirs", 40)});
  const std::vector<JudgedClaim> judged = {
      judgeOne({need(Predicate::Type::kScore, "recall", {"theirs"})}, {evidence})};
  EXPECT_THAT(claimsText(judged), HasSubstr("holds      it: it is so"));
  EXPECT_THAT(claimsText(judged), HasSubstr("1 holds, 0 fails, 0 undecided, 0 not run"));
  EXPECT_THAT(claimsMarkdown(judged), HasSubstr("| it is so | **holds** | result, office |"));
  const auto json = nlohmann::json::parse(claimsJson(judged));
  EXPECT_EQ(json[0]["verdict"], "holds");
  EXPECT_NEAR(json[0]["findings"][0]["difference"].get<double>(), 40.0 / 60, 1e-12);
  EXPECT_EQ(json[0]["findings"][0]["relation"], ">");
  EXPECT_EQ(json[0]["findings"][0]["bound"], 0);
}

}  // namespace
}  // namespace hydrabench

// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "core/types/random.h"
#include "metrics/aggregate.h"
#include "metrics/matching.h"
#include "metrics/surface_distance.h"
#include "tests/metrics/shapes.h"

// Mistakes found in published evaluation code, each written down here as it was made. Every test
// works the right value out by hand, shows that ours is that, and that the mistake gives another.
namespace hydrabench {
namespace {

using Objects = std::vector<DetectionObject>;
using Role = ObjectModel::Role;

DetectionObject at(ObjectId id, double x) { return {id, 1, {x, 0, 0}, 0.5}; }
const Threshold kTau = Threshold::tau(0.5);

ObjectModel model(const Mesh& mesh, Role role) {
  ObjectModel::Config config;
  config.jittered_origins = 0;
  return ObjectModel(mesh, role, config);
}

TEST(KnownWrong, ACentroidModeThatNeverRecordsMisses) {
  const Objects truths = {at(1, 0), at(2, 10), at(3, 20)};
  const Objects estimates = {at(1, 0.1), at(2, 15)};
  const DetectionMatches matches = matchExists(estimates, truths, kTau);
  // The list of failures stays empty, so each rate is divided by the successes.
  const double successes = static_cast<double>(matchedPairs(matches).size());
  const double failures = 0;
  const double wrong = successes / (successes + failures);
  EXPECT_EQ(wrong, 1.0);
  EXPECT_DOUBLE_EQ(*precision(counts(matches)), 1.0 / 2);
  EXPECT_DOUBLE_EQ(*recall(counts(matches)), 1.0 / 3);
}

TEST(KnownWrong, AMaximumIouInitialisedWithADistanceThreshold) {
  const ObjectModel truth = model(unitCube(), Role::kTruth);
  const ObjectModel estimate = model(unitCube(0.5), Role::kEstimate);
  const ObjectModel elsewhere = model(unitCube(40), Role::kEstimate);
  const auto wrong = [&](const ObjectModel& candidate) {
    double max_iou = 2.0;  // the matching distance in metres
    max_iou = std::max(max_iou, boxIou(candidate.box(), truth.box()));
    return max_iou;
  };
  EXPECT_EQ(wrong(estimate), 2.0);   // not even an IoU
  EXPECT_EQ(wrong(elsewhere), 2.0);  // so everything is associated
  EXPECT_NEAR(*scorePair(estimate, truth).b_iou, 1.0 / 3, 1e-12);
  EXPECT_EQ(scorePair(elsewhere, truth).b_iou, 0.0);
}

TEST(KnownWrong, RecallWithPredictionsInTheNumerator) {
  // One of two truths found, in five fragments.
  const Objects truths = {at(1, 0), at(2, 10)};
  const Objects estimates = {at(1, -0.2), at(2, -0.1), at(3, 0), at(4, 0.1), at(5, 0.2)};
  const DetectionCounts c = counts(matchExists(estimates, truths, kTau));
  const auto matched = static_cast<double>(c.matched_estimates);
  const auto missed = static_cast<double>(c.truths - c.found_truths);
  const double wrong = matched / (matched + missed);
  EXPECT_DOUBLE_EQ(wrong, 5.0 / 6);  // grows with every further fragment
  EXPECT_DOUBLE_EQ(*recall(c), 1.0 / 2);
}

/// Two sheets of 1 m^2 in the plane z = 0; the estimate has only the left half.
Mesh sheet(double size_x) {
  Mesh mesh;
  mesh.vertices = {{0, 0, 0}, {size_x, 0, 0}, {size_x, 1, 0}, {0, 1, 0}};
  mesh.faces = {{0, 1, 2}, {0, 2, 3}};
  return mesh;
}

TEST(KnownWrong, ChamferOverInliersOnly) {
  const SurfaceDistances d =
      surfaceDistances(model(sheet(0.5), Role::kEstimate), model(sheet(1), Role::kTruth));
  double sum = 0;
  int inliers = 0;
  for (const double distance : d.truth_to_estimate) {
    if (distance >= 0.05) continue;
    sum += distance;
    ++inliers;
  }
  const double wrong = sum / inliers;
  EXPECT_LT(wrong, 0.005);  // the half that is missing does not count
  EXPECT_NEAR(*completeness(d), 1.0 / 8, 2e-3);
  EXPECT_NEAR(*chamferL1(d), 1.0 / 16, 1e-3);
}

TEST(KnownWrong, AOneDirectionalChamfer) {
  const ObjectModel half = model(sheet(0.5), Role::kEstimate);
  const ObjectModel whole = model(sheet(1), Role::kTruth);
  const SurfaceDistances d = surfaceDistances(half, whole);
  double wrong = 0;
  for (const double distance : d.estimate_to_truth) wrong += distance * distance;
  EXPECT_EQ(wrong, 0);
  EXPECT_NEAR(*chamferSq(half, whole), 1.0 / 24, 1e-3);
  EXPECT_NEAR(*chamferL1(d), 1.0 / 16, 1e-3);
}

TEST(KnownWrong, MatchingInFileOrder) {
  // The first estimate could have either truth, the second only the first one.
  const Objects truths = {at(1, 0), at(2, 0.6)};
  const Objects estimates = {at(1, 0.25), at(2, -0.3)};
  const auto wrong = [&](const Objects& in_file_order) {
    std::vector<bool> taken(truths.size());
    int pairs = 0;
    for (const DetectionObject& estimate : in_file_order) {
      for (std::size_t g = 0; g < truths.size(); ++g) {
        if (taken[g] || (estimate.center - truths[g].center).norm() >= 0.5) continue;
        taken[g] = true;
        ++pairs;
        break;
      }
    }
    return pairs;
  };
  EXPECT_EQ(wrong({estimates[0], estimates[1]}), 1);
  EXPECT_EQ(wrong({estimates[1], estimates[0]}), 2);
  EXPECT_EQ(counts(matchOneToOne(estimates, truths, kTau)), (DetectionCounts{2, 2, 2, 2}));
  EXPECT_EQ(counts(matchOneToOne(Objects{estimates[1], estimates[0]}, truths, kTau)),
            (DetectionCounts{2, 2, 2, 2}));
}

TEST(KnownWrong, MeansThatSkipNanSilently) {
  PairScores good;
  good.v_iou_solid = 0.8;
  const PairScores no_value;  // where other code divides 0 by 0
  const std::vector<TruthOutcome> truths = {
      {1, 1, true, good}, {1, 1, true, no_value}, {1, 1, true, std::nullopt}, {1, 1, true, good}};
  const std::vector<PairOutcome> pairs = {{1, good}, {1, no_value}, {1, good}};
  const PairScoreColumn& column = *findPairScoreColumn("v_iou_solid");

  const double nan = std::numeric_limits<double>::quiet_NaN();
  double sum = 0;
  int n = 0;
  for (const double value : {0.8, nan, nan, 0.8}) {
    if (std::isnan(value)) continue;
    sum += value;
    ++n;
  }
  EXPECT_DOUBLE_EQ(sum / n, 0.8);  // says nothing of the two others
  const Mean over_truths = mean(valuesOverTruths(truths, column), Averaging::kMicro);
  EXPECT_DOUBLE_EQ(*over_truths.value, (0.8 + 0 + 0 + 0.8) / 4);
  EXPECT_EQ(over_truths.n, 4u);
  const Mean over_pairs = mean(valuesOverPairs(pairs, truths, column), Averaging::kMicro);
  EXPECT_EQ(over_pairs.n, 2u);
  EXPECT_EQ(over_pairs.undefined, 1u);
}

TEST(KnownWrong, F1AveragedOverRowsSoThatItExceedsBothPrecisionAndRecall) {
  const CountsByClass classes = {{1, {1, 1, 1, 1}}, {2, {9, 0, 9, 0}}};
  const double wrong =
      (*f1(classes.at(1)) + *f1(classes.at(2))) / 2;  // printed beside pooled P and R
  const double p = *score(classes, precision, Averaging::kMicro).value;
  const double r = *score(classes, recall, Averaging::kMicro).value;
  EXPECT_DOUBLE_EQ(p, 0.1);
  EXPECT_DOUBLE_EQ(r, 0.1);
  EXPECT_GT(wrong, std::max(p, r));
  EXPECT_DOUBLE_EQ(*score(classes, f1, Averaging::kMicro).value, 0.1);
}

TEST(KnownWrong, OursNeverExceedsBothPrecisionAndRecall) {
  Random random(6);
  for (int i = 0; i < 2000; ++i) {
    CountsByClass classes;
    for (Label label = 1; label <= 4; ++label) {
      DetectionCounts c;
      c.estimates = random.index(8);
      c.truths = 1 + random.index(8);
      if (c.estimates > 0) {
        c.matched_estimates = random.index(static_cast<std::uint32_t>(c.estimates) + 1);
        c.found_truths = random.index(static_cast<std::uint32_t>(c.truths) + 1);
      }
      classes[label] = c;
    }
    for (const Averaging averaging : {Averaging::kMicro, Averaging::kMacro}) {
      const double p = score(classes, precision, averaging).value.value_or(0);
      const double r = *score(classes, recall, averaging).value;
      EXPECT_LE(*score(classes, f1, averaging).value, std::max(p, r) + 1e-12);
    }
  }
}

}  // namespace
}  // namespace hydrabench

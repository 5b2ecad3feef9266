// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "metrics/kappa_sweep.h"

#include <gtest/gtest.h>

#include "metrics/matching.h"
#include "tests/metrics/random_objects.h"

namespace hydrabench {
namespace {

using Objects = std::vector<DetectionObject>;

TEST(KappaSweep, StepsWhereAPairOpensAndNowhereElse) {
  // d_diag 0.5, distances 0.25 and 0.5: the gate opens above kappa = 0.5; the second estimate above
  // 1 changes P only.
  const Objects truths = {{1, 1, {0, 0, 0}, 0.5}, {2, 1, {50, 0, 0}, 0.5}};
  const Objects estimates = {{1, 1, {0.25, 0, 0}, 0.5}, {2, 1, {-0.5, 0, 0}, 0.5}};
  const KappaSweep exists = sweepKappa(estimates, truths, Matching::kExists);
  ASSERT_GE(exists.steps.size(), 3u);
  EXPECT_EQ(exists.steps[0], (KappaSweep::Step{0, {2, 0, 2, 0}}));
  EXPECT_EQ(exists.steps[1], (KappaSweep::Step{0.5, {2, 1, 2, 1}}));
  EXPECT_EQ(exists.steps[2], (KappaSweep::Step{1.0, {2, 2, 2, 1}}));
  EXPECT_EQ(exists.at(0.5).matched_estimates, 0u) << "strict: the step itself is outside";
  EXPECT_EQ(exists.at(0.5000001).matched_estimates, 1u);

  const KappaSweep exclusive = sweepKappa(estimates, truths, Matching::kOneToOne);
  EXPECT_EQ(exclusive.steps[1], (KappaSweep::Step{0.5, {2, 1, 2, 1}}));
  EXPECT_EQ(exclusive.at(2), (DetectionCounts{2, 1, 2, 1})) << "the truth is taken";
}

TEST(KappaSweep, AreaIsTheHandWorkedIntegral) {
  const Objects truths = {{1, 1, {0, 0, 0}, 0.5}, {2, 1, {50, 0, 0}, 0.5}};
  const Objects estimates = {{1, 1, {0.25, 0, 0}, 0.5}, {2, 1, {-0.5, 0, 0}, 0.5}};
  const KappaSweep sweep = sweepKappa(estimates, truths, Matching::kExists);
  // F1 = 0 up to 0.5, then 1/2, then P = 1, R = 1/2: 2/3 from 1 to 2.
  EXPECT_DOUBLE_EQ(*areaUnderF1(sweep, 2), 0.5 * 0.5 + 1.0 * 2 / 3);
  EXPECT_DOUBLE_EQ(*areaUnderF1(sweep, 0.75), 0.25 * 0.5);
  EXPECT_EQ(*areaUnderF1(sweep, 0), 0);
}

TEST(KappaSweep, APerfectEstimateHasTheWholeArea) {
  Random random(3);
  const Objects truths = randomObjects(20, 3, 5, random);
  for (const Matching matching : {Matching::kExists, Matching::kOneToOne}) {
    EXPECT_DOUBLE_EQ(*areaUnderF1(sweepKappa(truths, truths, matching), 1.5), 1.5);
    EXPECT_EQ(sweepKappa(truths, truths, matching).at(0).found_truths, 0u);
  }
}

TEST(KappaSweep, EmptySetsHaveOneStep) {
  const Objects objects = {{1, 1, {0, 0, 0}, 0.5}};
  EXPECT_EQ(sweepKappa({}, objects, Matching::kOneToOne).steps.size(), 1u);
  EXPECT_EQ(areaUnderF1(sweepKappa({}, objects, Matching::kExists), 1), 0.0);
  EXPECT_EQ(areaUnderF1(sweepKappa({}, {}, Matching::kExists), 1), std::nullopt);
}

TEST(KappaSweep, EqualsMatchingAnewAtEveryKappa) {
  Random random(11);
  for (int world = 0; world < 8; ++world) {
    const Objects truths = randomObjects(15, 2, 1.5, random);
    const Objects estimates = randomObjects(18, 2, 1.5, random);
    for (const Matching matching : {Matching::kExists, Matching::kOneToOne}) {
      const KappaSweep sweep = sweepKappa(estimates, truths, matching);
      for (const KappaSample& sample : sampled(sweep, 4, 401)) {
        const Threshold threshold = Threshold::kappa(sample.kappa);
        ASSERT_EQ(sample.counts, counts(match(matching, estimates, truths, threshold)))
            << "kappa " << sample.kappa;
      }
      for (const KappaSweep::Step& step : sweep.steps) {  // on the steps and just beside them
        for (const double kappa : {step.kappa, std::nextafter(step.kappa, 1e9)}) {
          const Threshold threshold = Threshold::kappa(kappa);
          ASSERT_EQ(sweep.at(kappa), counts(match(matching, estimates, truths, threshold)));
        }
      }
    }
  }
}

TEST(KappaSweep, AreaAgreesWithDenseSampling) {
  Random random(12);
  const Objects truths = randomObjects(20, 2, 1.5, random);
  const Objects estimates = randomObjects(25, 2, 1.5, random);
  const KappaSweep sweep = sweepKappa(estimates, truths, Matching::kOneToOne);
  constexpr int kSamples = 200000;
  double sum = 0;
  for (int i = 0; i < kSamples; ++i) sum += *f1(sweep.at(2 * (i + 0.5) / kSamples));
  EXPECT_NEAR(*areaUnderF1(sweep, 2), 2 * sum / kSamples, 1e-4);
}

TEST(KappaSweep, DoesNotDependOnTheOrderOfTheInput) {
  Random random(13);
  Objects truths = randomObjects(15, 2, 1.5, random);
  Objects estimates = randomObjects(15, 2, 1.5, random);
  for (Objects* objects : {&truths, &estimates}) {
    for (DetectionObject& o : *objects) {
      o.center = (o.center * 4).array().round() / 4;  // many equal distances
      o.half_diagonal = 0.5;
    }
  }
  for (const Matching matching : {Matching::kExists, Matching::kOneToOne}) {
    const KappaSweep expected = sweepKappa(estimates, truths, matching);
    for (int i = 0; i < 500; ++i) {
      shuffle(truths, random);
      shuffle(estimates, random);
      ASSERT_EQ(sweepKappa(estimates, truths, matching).steps, expected.steps);
    }
  }
}

}  // namespace
}  // namespace hydrabench

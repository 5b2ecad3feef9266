// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "metrics/matching.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/metrics/random_objects.h"

namespace hydrabench {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

DetectionObject at(ObjectId id, double x, Label label = 1) { return {id, label, {x, 0, 0}, 0.5}; }
using Objects = std::vector<DetectionObject>;
const Threshold kTau = Threshold::tau(0.5);

TEST(MatchExists, SeveralEstimatesMayShareOneTruth) {
  const Objects truths = {at(1, 0), at(2, 10)};
  const Objects estimates = {at(1, 0.1), at(2, -0.2), at(3, 0.3), at(4, 5)};
  const DetectionMatches matches = matchExists(estimates, truths, kTau);
  EXPECT_EQ(counts(matches), (DetectionCounts{4, 3, 2, 1}));
  EXPECT_THAT(matchedPairs(matches),
              ElementsAre(MatchedPair{0, 0}, MatchedPair{1, 0}, MatchedPair{2, 0}));
  EXPECT_THAT(matches.ambiguous_truths, ElementsAre(0u));
  EXPECT_THAT(matches.duplicates, IsEmpty());
}

TEST(MatchExists, OneEstimateMayFindSeveralTruths) {
  const Objects truths = {at(1, -0.3), at(2, 0.3)};
  const Objects estimates = {at(1, 0.05)};
  const DetectionMatches matches = matchExists(estimates, truths, kTau);
  EXPECT_EQ(counts(matches), (DetectionCounts{1, 1, 2, 2}));
  EXPECT_THAT(matchedPairs(matches), ElementsAre(MatchedPair{0, 1}));
  EXPECT_THAT(pairsToScore(matches), ElementsAre(MatchedPair{0, 0}, MatchedPair{0, 1}));
}

TEST(MatchExists, EqualDistancesGoToTheSmallerId) {
  const Objects truths = {at(9, -0.25), at(4, 0.25)};
  const Objects estimates = {at(1, 0)};
  EXPECT_EQ(matchExists(estimates, truths, kTau).truth_of_estimate[0], 1u);
}

TEST(MatchExists, UnderKappaTheNearestTruthMayHaveTooSmallAGate) {
  Objects truths = {at(1, 0.2), at(2, -0.4)};
  truths[0].half_diagonal = 0.1;
  truths[1].half_diagonal = 1.0;
  const Objects estimates = {at(1, 0)};
  EXPECT_EQ(matchExists(estimates, truths, Threshold::kappa(1)).truth_of_estimate[0], 1u);
}

TEST(MatchOneToOne, TakesAsManyPairsAsPossibleBeforeItMindsTheDistance) {
  // Nearest first would give e0 its nearest truth g0 and leave e1 with nothing.
  const Objects truths = {at(1, 0), at(2, 0.6)};
  const Objects estimates = {at(1, 0.25), at(2, -0.3)};
  const DetectionMatches matches = matchOneToOne(estimates, truths, kTau);
  EXPECT_THAT(matchedPairs(matches), ElementsAre(MatchedPair{0, 1}, MatchedPair{1, 0}));
}

TEST(MatchOneToOne, TakesTheSmallestTotalDistanceAmongEqualNumbers) {
  // Nearest first (e1-g0) leaves 0.1 + 0.45; the other way round 0.15 + 0.2.
  const Objects truths = {at(1, 0), at(2, 0.3)};
  const Objects estimates = {at(1, -0.15), at(2, 0.1)};
  const DetectionMatches matches = matchOneToOne(estimates, truths, kTau);
  EXPECT_THAT(matchedPairs(matches), ElementsAre(MatchedPair{0, 0}, MatchedPair{1, 1}));
}

TEST(MatchOneToOne, CountsDuplicatesAndAmbiguousTruths) {
  const Objects truths = {at(1, 0), at(2, 10)};
  const Objects estimates = {at(1, 0.1), at(2, 0.2), at(3, -0.3), at(4, 10), at(5, 20)};
  const DetectionMatches matches = matchOneToOne(estimates, truths, kTau);
  EXPECT_EQ(counts(matches), (DetectionCounts{5, 2, 2, 2}));
  EXPECT_THAT(matches.duplicates, ElementsAre(1u, 2u));
  EXPECT_THAT(matches.ambiguous_truths, ElementsAre(0u));
}

TEST(Matching, LabelsMustAgree) {
  const Objects truths = {at(1, 0, 1)};
  const Objects estimates = {at(1, 0, 2)};
  for (const Matching matching : {Matching::kExists, Matching::kOneToOne}) {
    const DetectionMatches matches = match(matching, estimates, truths, kTau);
    EXPECT_EQ(counts(matches), (DetectionCounts{1, 0, 1, 0}));
    const CountsByClass classes = countsByClass(matches, estimates, truths);
    EXPECT_EQ(classes.at(1), (DetectionCounts{0, 0, 1, 0}));
    EXPECT_EQ(classes.at(2), (DetectionCounts{1, 0, 0, 0}));
  }
}

TEST(Matching, EverythingShiftedByExactlyTauMatchesNothing) {
  const Objects truths = {at(1, 0), at(2, 8)};
  const Objects estimates = {at(1, 0.5), at(2, 8.5)};
  for (const Matching matching : {Matching::kExists, Matching::kOneToOne}) {
    EXPECT_EQ(counts(match(matching, estimates, truths, Threshold::tau(0.5))),
              (DetectionCounts{2, 0, 2, 0}));
    EXPECT_EQ(counts(match(matching, estimates, truths, Threshold::kappa(1))),
              (DetectionCounts{2, 0, 2, 0}));
    EXPECT_EQ(counts(match(matching, estimates, truths, Threshold::tau(0.5000001))),
              (DetectionCounts{2, 2, 2, 2}));
  }
}

TEST(Matching, EverythingDuplicatedHalvesOneToOnePrecisionOnly) {
  const Objects truths = {at(1, 0), at(2, 10), at(3, 20)};
  Objects estimates = truths;
  for (const DetectionObject& truth : truths)
    estimates.push_back(at(truth.id + 10, truth.center.x()));
  const DetectionCounts shared = counts(matchExists(estimates, truths, kTau));
  EXPECT_EQ(precision(shared), 1.0);
  EXPECT_EQ(recall(shared), 1.0);
  const DetectionMatches exclusive = matchOneToOne(estimates, truths, kTau);
  EXPECT_EQ(precision(counts(exclusive)), 0.5);
  EXPECT_EQ(recall(counts(exclusive)), 1.0);
  EXPECT_EQ(exclusive.duplicates.size(), 3u);
}

TEST(Matching, EmptySetsMatchNothing) {
  const Objects objects = {at(1, 0), at(2, 1)};
  for (const Matching matching : {Matching::kExists, Matching::kOneToOne}) {
    EXPECT_EQ(counts(match(matching, {}, objects, kTau)), (DetectionCounts{0, 0, 2, 0}));
    EXPECT_EQ(counts(match(matching, objects, {}, kTau)), (DetectionCounts{2, 0, 0, 0}));
    EXPECT_EQ(counts(match(matching, {}, {}, kTau)), DetectionCounts{});
  }
}

/// Partners by id, so that answers for shuffled inputs can be compared.
std::map<ObjectId, ObjectId> partnersById(const DetectionMatches& matches, const Objects& estimates,
                                          const Objects& truths) {
  std::map<ObjectId, ObjectId> partners;
  for (const MatchedPair& pair : matchedPairs(matches)) {
    partners[estimates[pair.estimate].id] = truths[pair.truth].id;
  }
  return partners;
}

TEST(Matching, DoesNotDependOnTheOrderOfTheInput) {
  Random random(17);
  for (int world = 0; world < 20; ++world) {
    Objects truths = randomObjects(25, 2, 2.0, random);
    Objects estimates = randomObjects(30, 2, 2.0, random);
    // Positions on a coarse lattice give many equal distances.
    for (Objects* objects : {&truths, &estimates}) {
      for (DetectionObject& o : *objects) o.center = (o.center * 4).array().round() / 4;
    }
    for (const Threshold& threshold : {Threshold::tau(0.6), Threshold::kappa(0.8)}) {
      for (const Matching matching : {Matching::kExists, Matching::kOneToOne}) {
        const DetectionMatches first = match(matching, estimates, truths, threshold);
        const auto expected = partnersById(first, estimates, truths);
        for (int i = 0; i < 50; ++i) {
          Objects e = estimates, g = truths;
          shuffle(e, random);
          shuffle(g, random);
          const DetectionMatches again = match(matching, e, g, threshold);
          ASSERT_EQ(partnersById(again, e, g), expected);
          ASSERT_EQ(counts(again), counts(first));
          ASSERT_EQ(again.duplicates.size(), first.duplicates.size());
          ASSERT_EQ(again.ambiguous_truths.size(), first.ambiguous_truths.size());
        }
      }
    }
  }
}

TEST(Matching, CountsDoNotDependOnIds) {
  Random random(18);
  const Objects truths = randomObjects(40, 3, 3.0, random);
  Objects estimates = randomObjects(50, 3, 3.0, random);
  for (const Matching matching : {Matching::kExists, Matching::kOneToOne}) {
    const DetectionCounts expected = counts(match(matching, estimates, truths, kTau));
    for (int i = 0; i < 1000; ++i) {
      for (DetectionObject& estimate : estimates) estimate.id = random.bits();
      ASSERT_EQ(counts(match(matching, estimates, truths, kTau)), expected);
    }
  }
}

TEST(Matching, CountsOfTheClassesSumToAll) {
  Random random(19);
  const Objects truths = randomObjects(40, 5, 2.0, random);
  const Objects estimates = randomObjects(60, 6, 2.0, random);
  const DetectionMatches matches = matchOneToOne(estimates, truths, kTau);
  DetectionCounts sum;
  for (const auto& [label, of_class] : countsByClass(matches, estimates, truths)) sum += of_class;
  EXPECT_EQ(sum, counts(matches));
}

}  // namespace
}  // namespace hydrabench

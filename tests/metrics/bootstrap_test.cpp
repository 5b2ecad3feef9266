// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "metrics/bootstrap.h"

#include <cmath>

#include <gtest/gtest.h>

#include "core/types/random.h"

namespace hydrabench {
namespace {

TEST(Bootstrap, IsDeterministicAndDependsOnTheSeed) {
  const CountsByClass counts = {{1, {30, 20, 25, 15}}, {2, {10, 5, 12, 6}}};
  const DetectionIntervals first = bootstrapDetection(counts, Averaging::kMicro, {});
  const DetectionIntervals again = bootstrapDetection(counts, Averaging::kMicro, {});
  EXPECT_EQ(first.f1, again.f1);
  EXPECT_EQ(first.precision, again.precision);
  BootstrapConfig other;
  other.seed = 1;
  EXPECT_NE(first.f1, bootstrapDetection(counts, Averaging::kMicro, other).f1);
}

TEST(Bootstrap, IntervalsContainTheScoreAndLieInItsRange) {
  const CountsByClass counts = {{1, {30, 20, 25, 15}}, {2, {10, 5, 12, 6}}};
  for (const Averaging averaging : {Averaging::kMicro, Averaging::kMacro}) {
    const DetectionIntervals intervals = bootstrapDetection(counts, averaging, {});
    const auto expect_inside = [&](const std::optional<Interval>& interval, DetectionScore s) {
      const double value = *score(counts, s, averaging).value;
      EXPECT_LT(interval->low, value);
      EXPECT_GT(interval->high, value);
      EXPECT_GE(interval->low, 0);
      EXPECT_LE(interval->high, 1);
    };
    expect_inside(intervals.precision, precision);
    expect_inside(intervals.recall, recall);
    expect_inside(intervals.f1, f1);
  }
}

TEST(Bootstrap, ACertainScoreHasAPointInterval) {
  const CountsByClass counts = {{1, {10, 10, 10, 10}}, {2, {5, 5, 5, 5}}};
  const DetectionIntervals intervals = bootstrapDetection(counts, Averaging::kMicro, {});
  EXPECT_EQ(intervals.f1, (Interval{1, 1}));
  const ValuesByClass values = {{1, {{0.5, 0.5, 0.5}, 0}}};
  EXPECT_EQ(bootstrapMean(values, Averaging::kMacro, {}), (Interval{0.5, 0.5}));
}

TEST(Bootstrap, KeepsTheClassesApart) {
  // All of class 1 found, none of class 2: with strata nothing is left to chance, without them
  // recall would spread around 1/2.
  const CountsByClass counts = {{1, {10, 10, 10, 10}}, {2, {10, 0, 10, 0}}};
  EXPECT_EQ(bootstrapDetection(counts, Averaging::kMicro, {}).recall, (Interval{0.5, 0.5}));
}

TEST(Bootstrap, IsUndefinedWhereTheScoreIs) {
  const CountsByClass no_estimates = {{1, {0, 0, 10, 0}}};
  const DetectionIntervals intervals = bootstrapDetection(no_estimates, Averaging::kMicro, {});
  EXPECT_FALSE(intervals.precision);
  EXPECT_EQ(intervals.recall, (Interval{0, 0}));
  EXPECT_EQ(intervals.f1, (Interval{0, 0}));
  EXPECT_FALSE(bootstrapDetection({}, Averaging::kMacro, {}).f1);
  EXPECT_FALSE(bootstrapMean({}, Averaging::kMicro, {}));
  EXPECT_FALSE(bootstrapMean({{1, {}}}, Averaging::kMacro, {}));
  EXPECT_FALSE(pairedBootstrap({}, Averaging::kMicro, {}));
  EXPECT_FALSE(pairedBootstrapDetection({}, f1, Averaging::kMicro, {}));
}

TEST(Bootstrap, WidthOfAProportionIsTheBinomialOne) {
  const CountsByClass counts = {{1, {0, 0, 400, 160}}};
  const Interval recall_interval = *bootstrapDetection(counts, Averaging::kMicro, {}).recall;
  const double deviation = std::sqrt(0.4 * 0.6 / 400);
  EXPECT_NEAR(recall_interval.high - recall_interval.low, 2 * 1.96 * deviation,
              0.1 * 4 * deviation);
}

TEST(Bootstrap, LimitsOfAProportionAreQuantilesOfTheBinomial) {
  // Of Binomial(100, 0.9): P(X <= 83) = 0.0206, P(X <= 84) = 0.0399; P(X <= 94) = 0.9424,
  // P(X <= 95) = 0.9763.
  const CountsByClass counts = {{1, {100, 90, 0, 0}}};
  const Interval interval =
      *bootstrapDetection(counts, Averaging::kMicro, {20000, 0.95, 0}).precision;
  EXPECT_DOUBLE_EQ(interval.low, 0.84);
  EXPECT_DOUBLE_EQ(interval.high, 0.95);
}

TEST(Bootstrap, CoversTheTruthAboutAsOftenAsItSays) {
  BootstrapConfig config;
  config.resamples = 300;
  Random random(21);
  int covered_mean = 0, covered_recall = 0;
  constexpr int kWorlds = 400;
  for (int world = 0; world < kWorlds; ++world) {
    config.seed = static_cast<std::uint64_t>(world);
    ClassSample sample;
    DetectionCounts counts{0, 0, 60, 0};
    for (int i = 0; i < 60; ++i) {
      sample.values.push_back(random.uniform());
      counts.found_truths += random.chance(0.6);
    }
    std::sort(sample.values.begin(), sample.values.end());
    const Interval of_mean = *bootstrapMean({{1, sample}}, Averaging::kMicro, config);
    covered_mean += of_mean.low <= 0.5 && 0.5 <= of_mean.high;
    const Interval of_recall = *bootstrapDetection({{1, counts}}, Averaging::kMicro, config).recall;
    covered_recall += of_recall.low <= 0.6 && 0.6 <= of_recall.high;
  }
  EXPECT_GT(covered_mean, 0.90 * kWorlds);
  EXPECT_LT(covered_mean, 0.99 * kWorlds);
  EXPECT_GT(covered_recall, 0.89 * kWorlds);
  EXPECT_LT(covered_recall, 0.99 * kWorlds);
}

PairedValuesByClass pairedScores(double advantage, std::size_t count, std::uint64_t seed) {
  Random random(seed);
  PairedValuesByClass values;
  for (std::size_t i = 0; i < count; ++i) {
    const double difficulty = random.uniform();  // shared, and much larger than the advantage
    values[static_cast<Label>(i % 3)].push_back(
        {difficulty + advantage + 0.02 * random.normal(), difficulty + 0.02 * random.normal()});
  }
  return values;
}

TEST(PairedBootstrap, SeesASmallAdvantageThroughASharedDifficulty) {
  const PairedComparison better =
      *pairedBootstrap(pairedScores(0.03, 90, 1), Averaging::kMicro, {});
  EXPECT_NEAR(better.difference, 0.03, 0.01);
  EXPECT_GT(better.interval.low, 0);
  EXPECT_LT(better.p_value, 0.01);
}

TEST(PairedBootstrap, DoesNotSeeAnAdvantageWhereThereIsNone) {
  int rejected = 0;
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    BootstrapConfig config;
    config.resamples = 300;
    rejected +=
        pairedBootstrap(pairedScores(0, 60, seed), Averaging::kMacro, config)->p_value < 0.05;
  }
  EXPECT_LT(rejected, 25);  // 10 expected
}

TEST(PairedBootstrap, OfEqualMethodsIsCertainlyUndecided) {
  const PairedValuesByClass values = {{1, {{0.5, 0.5}, {0.7, 0.7}}}};
  const PairedComparison comparison = *pairedBootstrap(values, Averaging::kMicro, {});
  EXPECT_EQ(comparison.difference, 0);
  EXPECT_EQ(comparison.p_value, 1);
}

TEST(PairedBootstrap, IsAntisymmetricAndDoesNotDependOnTheOrder) {
  const PairedValuesByClass values = pairedScores(0.01, 60, 2);
  PairedValuesByClass swapped = values, reversed = values;
  for (auto& [label, pairs] : swapped) {
    for (PairedValue& pair : pairs) std::swap(pair.a, pair.b);
  }
  for (auto& [label, pairs] : reversed) std::reverse(pairs.begin(), pairs.end());
  const PairedComparison plain = *pairedBootstrap(values, Averaging::kMicro, {});
  EXPECT_NEAR(pairedBootstrap(swapped, Averaging::kMicro, {})->difference, -plain.difference,
              1e-12);
  EXPECT_EQ(pairedBootstrap(reversed, Averaging::kMicro, {})->interval, plain.interval);
}

TEST(PairedBootstrapF1, IsTheDifferenceOfTheScores) {
  PairedDetection of_class;
  of_class.estimates_a = 50, of_class.matched_estimates_a = 45;
  of_class.estimates_b = 60, of_class.matched_estimates_b = 24;
  for (int i = 0; i < 50; ++i) of_class.found.push_back({i < 45 ? 1.0 : 0.0, i < 25 ? 1.0 : 0.0});
  const PairedComparison comparison =
      *pairedBootstrapDetection({{1, of_class}}, f1, Averaging::kMicro, {});
  EXPECT_DOUBLE_EQ(comparison.difference, 0.9 - 2 * 0.4 * 0.5 / 0.9);
  EXPECT_LT(comparison.interval.low, comparison.difference);
  EXPECT_GT(comparison.interval.low, 0.2);
  EXPECT_LT(comparison.p_value, 0.01);
}

TEST(PairedBootstrapDetection, TakesAnyOfTheThreeScores) {
  PairedDetection of_class;
  of_class.estimates_a = 50, of_class.matched_estimates_a = 45;
  of_class.estimates_b = 60, of_class.matched_estimates_b = 24;
  for (int i = 0; i < 50; ++i) of_class.found.push_back({i < 45 ? 1.0 : 0.0, i < 25 ? 1.0 : 0.0});
  const auto difference = [&](DetectionScore score) {
    return pairedBootstrapDetection({{1, of_class}}, score, Averaging::kMicro, {})->difference;
  };
  EXPECT_DOUBLE_EQ(difference(precision), 45.0 / 50 - 24.0 / 60);
  EXPECT_DOUBLE_EQ(difference(recall), 45.0 / 50 - 25.0 / 50);
}

TEST(BootstrapStatistic, OfAMeanIsAsWideAsItsStandardError) {
  // 400 values 0 or 1, half each: the mean has a standard error of 0.5 / 20.
  std::vector<double> values;
  for (int i = 0; i < 400; ++i) values.push_back(i % 2);
  const std::vector<std::size_t> strata = {values.size()};
  const PairedComparison comparison =
      *bootstrapStatistic(strata,
                          [&](std::span<const std::size_t> drawn) -> std::optional<double> {
                            double sum = 0;
                            for (const std::size_t i : drawn) sum += values[i];
                            return sum / static_cast<double>(drawn.size());
                          },
                          {});
  EXPECT_DOUBLE_EQ(comparison.difference, 0.5);
  EXPECT_NEAR(comparison.interval.low, 0.5 - 1.96 * 0.025, 0.004);
  EXPECT_NEAR(comparison.interval.high, 0.5 + 1.96 * 0.025, 0.004);
}

TEST(BootstrapStatistic, DrawsEveryStratumAtItsOwnSize) {
  const std::vector<std::size_t> strata = {3, 0, 5};
  const auto comparison = bootstrapStatistic(
      strata,
      [](std::span<const std::size_t> drawn) -> std::optional<double> {
        const auto first = std::count_if(drawn.begin(), drawn.end(), [](auto i) { return i < 3; });
        return static_cast<double>(first) + (drawn.size() == 8 ? 0 : 100);
      },
      {});
  EXPECT_EQ(comparison->interval, (Interval{3, 3}));
}

TEST(BootstrapStatistic, IsUndefinedWhereTheDataDoNotDefineIt) {
  const std::vector<std::size_t> strata = {2};
  EXPECT_FALSE(bootstrapStatistic(
      strata, [](std::span<const std::size_t>) { return std::optional<double>(); }, {}));
}

}  // namespace
}  // namespace hydrabench

// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "metrics/bootstrap.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <numeric>

#include "core/types/random.h"

namespace hydrabench {
namespace {

/// Quantile by linear interpolation between order statistics (type 7 of Hyndman and Fan, 1996).
/// Changes the order of the values.
double quantile(std::vector<double>& values, double fraction) {
  const double position = fraction * static_cast<double>(values.size() - 1);
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(std::floor(position));
  std::nth_element(values.begin(), at, values.end());
  const double below = *at;
  const double above = at + 1 == values.end() ? below : *std::min_element(at + 1, values.end());
  return below + (position - std::floor(position)) * (above - below);
}

Interval percentileInterval(std::vector<double>& statistics, double confidence) {
  const double tail = (1 - confidence) / 2;
  return {quantile(statistics, tail), quantile(statistics, 1 - tail)};
}

/// The statistic of every resample. With the sizes of all classes fixed, a statistic that is
/// defined on the data is defined on all resamples.
template <typename Resample>
std::vector<double> resampled(const BootstrapConfig& config, const Resample& resample) {
  assert(config.resamples > 0 && config.confidence > 0 && config.confidence < 1);
  std::vector<double> statistics;
  for (int i = 0; i < config.resamples; ++i) {
    Random random(config.seed, static_cast<std::uint64_t>(i));
    statistics.push_back(resample(random));
  }
  return statistics;
}

/// How many of `count` draws with replacement hit one of `marked` among `count` objects: binomial,
/// by inversion of its distribution function, one random number each instead of `count`.
class HitCount {
 public:
  HitCount(std::size_t marked, std::size_t count) {
    if (marked == 0 || marked == count) {
      certain_ = marked;
      return;
    }
    // Weights relative to that of the mode, from there to both sides: nothing over- or underflows
    // where it matters.
    const double odds = static_cast<double>(marked) / static_cast<double>(count - marked);
    cumulative_.assign(count + 1, 0);
    cumulative_[marked] = 1;
    for (std::size_t k = marked; k < count; ++k) {
      cumulative_[k + 1] =
          cumulative_[k] * odds * static_cast<double>(count - k) / static_cast<double>(k + 1);
    }
    for (std::size_t k = marked; k > 0; --k) {
      cumulative_[k - 1] =
          cumulative_[k] / odds * static_cast<double>(k) / static_cast<double>(count - k + 1);
    }
    std::partial_sum(cumulative_.begin(), cumulative_.end(), cumulative_.begin());
  }

  std::size_t draw(Random& random) const {
    if (cumulative_.empty()) return certain_;
    const double target = random.uniform() * cumulative_.back();
    const auto above = std::upper_bound(cumulative_.begin(), cumulative_.end(), target);
    // Rounding can put the target at the very end.
    return std::min(static_cast<std::size_t>(above - cumulative_.begin()), cumulative_.size() - 1);
  }

 private:
  std::size_t certain_ = 0;
  std::vector<double> cumulative_;  ///< not normalised; empty: always certain_
};

/// Averages of sums over classes: micro pools sums and sizes, macro averages the quotients.
class StratifiedMean {
 public:
  explicit StratifiedMean(Averaging averaging) : averaging_(averaging) {}
  void add(double class_sum, std::size_t class_size) {
    if (class_size == 0) return;
    const auto size = static_cast<double>(class_size);
    sum_ += averaging_ == Averaging::kMicro ? class_sum : class_sum / size;
    weight_ += averaging_ == Averaging::kMicro ? size : 1;
  }
  double get() const { return sum_ / weight_; }

 private:
  Averaging averaging_;
  double sum_ = 0;
  double weight_ = 0;
};

PairedComparison compare(double difference, std::vector<double> differences,
                         const BootstrapConfig& config) {
  const auto count = [&](auto&& test) {
    return static_cast<double>(std::count_if(differences.begin(), differences.end(), test));
  };
  const double beyond =
      std::min(count([](double d) { return d <= 0; }), count([](double d) { return d >= 0; }));
  PairedComparison comparison;
  comparison.difference = difference;
  comparison.p_value =
      std::min(1.0, 2 * (beyond + 1) / (static_cast<double>(differences.size()) + 1.0));
  comparison.interval = percentileInterval(differences, config.confidence);
  return comparison;
}

/// In an order that no order of the input reaches.
std::vector<PairedValue> sorted(std::vector<PairedValue> values) {
  std::sort(values.begin(), values.end(), [](const PairedValue& x, const PairedValue& y) {
    return x.a != y.a ? x.a < y.a : x.b < y.b;
  });
  return values;
}

/// One draw of as many pairs, summed.
PairedValue redrawSum(const std::vector<PairedValue>& values, Random& random) {
  PairedValue sum;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const PairedValue& value = values[random.index(static_cast<std::uint32_t>(values.size()))];
    sum.a += value.a;
    sum.b += value.b;
  }
  return sum;
}

PairedValue plainSum(const std::vector<PairedValue>& values) {
  PairedValue sum;
  for (const PairedValue& value : values) {
    sum.a += value.a;
    sum.b += value.b;
  }
  return sum;
}

}  // namespace

DetectionIntervals bootstrapDetection(const CountsByClass& counts, Averaging averaging,
                                      const BootstrapConfig& config) {
  struct ClassDraws {
    DetectionCounts* drawn;
    HitCount matched;
    HitCount found;
  };
  CountsByClass drawn = counts;
  std::vector<ClassDraws> classes;
  for (auto& [label, of_class] : drawn) {
    classes.push_back({&of_class, HitCount(of_class.matched_estimates, of_class.estimates),
                       HitCount(of_class.found_truths, of_class.truths)});
  }
  // All three scores of the same draws. Whether one is defined depends on the sizes alone.
  std::array<std::vector<double>, std::size(kDetectionScores)> values;
  for (int i = 0; i < config.resamples; ++i) {
    Random random(config.seed, static_cast<std::uint64_t>(i));
    for (ClassDraws& of_class : classes) {
      of_class.drawn->matched_estimates = of_class.matched.draw(random);
      of_class.drawn->found_truths = of_class.found.draw(random);
    }
    for (std::size_t s = 0; s < values.size(); ++s) {
      const auto value = score(drawn, kDetectionScores[s].value, averaging).value;
      if (value) values[s].push_back(*value);
    }
  }
  DetectionIntervals intervals;
  for (std::size_t s = 0; s < values.size(); ++s) {
    if (values[s].empty()) continue;
    intervals.*kDetectionScores[s].interval = percentileInterval(values[s], config.confidence);
  }
  return intervals;
}

std::optional<Interval> bootstrapMean(const ValuesByClass& values, Averaging averaging,
                                      const BootstrapConfig& config) {
  if (!mean(values, averaging).value) return std::nullopt;
  std::vector<double> means = resampled(config, [&](Random& random) {
    StratifiedMean total(averaging);
    for (const auto& [label, sample] : values) {
      const auto size = static_cast<std::uint32_t>(sample.values.size());
      double sum = 0;
      for (std::uint32_t i = 0; i < size; ++i) sum += sample.values[random.index(size)];
      total.add(sum, size);
    }
    return total.get();
  });
  return percentileInterval(means, config.confidence);
}

std::optional<PairedComparison> pairedBootstrap(const PairedValuesByClass& values,
                                                Averaging averaging,
                                                const BootstrapConfig& config) {
  std::vector<std::vector<PairedValue>> classes;
  for (const auto& [label, of_class] : values) {
    if (!of_class.empty()) classes.push_back(sorted(of_class));
  }
  if (classes.empty()) return std::nullopt;
  const auto difference = [&](const auto& sum_of) {
    StratifiedMean total(averaging);
    for (const std::vector<PairedValue>& of_class : classes) {
      const PairedValue sum = sum_of(of_class);
      total.add(sum.a - sum.b, of_class.size());
    }
    return total.get();
  };
  std::vector<double> differences = resampled(config, [&](Random& random) {
    return difference([&](const auto& of_class) { return redrawSum(of_class, random); });
  });
  return compare(difference(plainSum), std::move(differences), config);
}

std::optional<PairedComparison> pairedBootstrapDetection(
    const std::map<Label, PairedDetection>& classes, DetectionScore detection_score,
    Averaging averaging, const BootstrapConfig& config) {
  struct Draws {
    HitCount matched_a;
    HitCount matched_b;
  };
  std::map<Label, PairedDetection> ordered = classes;
  std::map<Label, Draws> draws;
  for (auto& [label, of_class] : ordered) {
    of_class.found = sorted(std::move(of_class.found));
    draws.emplace(label, Draws{HitCount(of_class.matched_estimates_a, of_class.estimates_a),
                               HitCount(of_class.matched_estimates_b, of_class.estimates_b)});
  }

  // Without random numbers: of the data themselves.
  const auto difference = [&](Random* random) {
    CountsByClass counts_a, counts_b;
    for (const auto& [label, c] : ordered) {
      const PairedValue found = random ? redrawSum(c.found, *random) : plainSum(c.found);
      const Draws& of_class = draws.at(label);
      counts_a[label] = {c.estimates_a,
                         random ? of_class.matched_a.draw(*random) : c.matched_estimates_a,
                         c.found.size(), static_cast<std::size_t>(found.a)};
      counts_b[label] = {c.estimates_b,
                         random ? of_class.matched_b.draw(*random) : c.matched_estimates_b,
                         c.found.size(), static_cast<std::size_t>(found.b)};
    }
    const std::optional<double> score_a = score(counts_a, detection_score, averaging).value;
    const std::optional<double> score_b = score(counts_b, detection_score, averaging).value;
    return score_a && score_b ? std::optional<double>(*score_a - *score_b) : std::nullopt;
  };
  const std::optional<double> observed = difference(nullptr);
  if (!observed) return std::nullopt;
  std::vector<double> differences =
      resampled(config, [&](Random& random) { return difference(&random).value_or(0); });
  return compare(*observed, std::move(differences), config);
}

std::optional<PairedComparison> bootstrapStatistic(std::span<const std::size_t> stratum_sizes,
                                                   const DrawStatistic& statistic,
                                                   const BootstrapConfig& config) {
  std::vector<std::size_t> drawn(
      std::accumulate(stratum_sizes.begin(), stratum_sizes.end(), std::size_t{0}));
  std::iota(drawn.begin(), drawn.end(), std::size_t{0});
  const std::optional<double> observed = statistic(drawn);
  if (!observed) return std::nullopt;
  std::vector<double> values;
  for (int i = 0; i < config.resamples; ++i) {
    Random random(config.seed, static_cast<std::uint64_t>(i));
    std::size_t first = 0;
    for (const std::size_t size : stratum_sizes) {
      for (std::size_t k = first; k < first + size; ++k) {
        drawn[k] = first + random.index(static_cast<std::uint32_t>(size));
      }
      first += size;
    }
    if (const auto value = statistic(drawn)) values.push_back(*value);
  }
  if (values.empty()) return std::nullopt;
  return compare(*observed, std::move(values), config);
}

}  // namespace hydrabench

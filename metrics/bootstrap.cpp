// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "metrics/bootstrap.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numeric>

#include "core/types/random.h"

namespace hydrabench {
namespace {

/// Quantile by linear interpolation between order statistics (type 7 of Hyndman and Fan, 1996).
double quantile(std::span<const double> ascending, double fraction) {
  const double position = fraction * static_cast<double>(ascending.size() - 1);
  const auto below = static_cast<std::size_t>(std::floor(position));
  const std::size_t above = std::min(below + 1, ascending.size() - 1);
  const double weight = position - static_cast<double>(below);
  return ascending[below] + weight * (ascending[above] - ascending[below]);
}

Interval percentileInterval(std::vector<double>& statistics, double confidence) {
  std::sort(statistics.begin(), statistics.end());
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

/// How many of `count` draws hit one of `marked` among `count` objects.
std::size_t redraw(std::size_t marked, std::size_t count, Random& random) {
  std::size_t hits = 0;
  for (std::size_t i = 0; i < count; ++i) {
    hits += random.index(static_cast<std::uint32_t>(count)) < marked;
  }
  return hits;
}

CountsByClass redraw(const CountsByClass& counts, Random& random) {
  CountsByClass redrawn = counts;
  for (auto& [label, of_class] : redrawn) {
    of_class.matched_estimates = redraw(of_class.matched_estimates, of_class.estimates, random);
    of_class.found_truths = redraw(of_class.found_truths, of_class.truths, random);
  }
  return redrawn;
}

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
  // The three scores see the same resamples, because each begins the same streams of random
  // numbers.
  const auto interval = [&](DetectionScore detection_score) -> std::optional<Interval> {
    if (!score(counts, detection_score, averaging).value) return std::nullopt;
    std::vector<double> scores = resampled(config, [&](Random& random) {
      return *score(redraw(counts, random), detection_score, averaging).value;
    });
    return percentileInterval(scores, config.confidence);
  };
  return {interval(precision), interval(recall), interval(f1)};
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
  std::map<Label, PairedDetection> ordered = classes;
  for (auto& [label, of_class] : ordered) of_class.found = sorted(std::move(of_class.found));

  const auto difference = [&](const auto& found_sum, const auto& matched) {
    CountsByClass counts_a, counts_b;
    for (const auto& [label, c] : ordered) {
      const PairedValue found = found_sum(c.found);
      counts_a[label] = {c.estimates_a, matched(c.matched_estimates_a, c.estimates_a),
                         c.found.size(), static_cast<std::size_t>(found.a)};
      counts_b[label] = {c.estimates_b, matched(c.matched_estimates_b, c.estimates_b),
                         c.found.size(), static_cast<std::size_t>(found.b)};
    }
    const std::optional<double> score_a = score(counts_a, detection_score, averaging).value;
    const std::optional<double> score_b = score(counts_b, detection_score, averaging).value;
    return score_a && score_b ? std::optional<double>(*score_a - *score_b) : std::nullopt;
  };
  const std::optional<double> observed =
      difference(plainSum, [](std::size_t marked, std::size_t) { return marked; });
  if (!observed) return std::nullopt;
  std::vector<double> differences = resampled(config, [&](Random& random) {
    const auto drawn = difference(
        [&](const auto& found) { return redrawSum(found, random); },
        [&](std::size_t marked, std::size_t count) { return redraw(marked, count, random); });
    return drawn.value_or(0);
  });
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

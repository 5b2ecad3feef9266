// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <vector>

#include "metrics/aggregate.h"
#include "metrics/detection.h"

namespace hydrabench {

/// Percentile bootstrap (Efron and Tibshirani 1993, ch. 13), stratified by class: every resample
/// draws as many objects of a class as there are, with replacement. Matching is not repeated: what
/// is resampled is whether an object was matched, or what it scored. The same seed gives the same
/// interval, for any order of the objects.
struct BootstrapConfig {
  int resamples = 2000;
  double confidence = 0.95;
  std::uint64_t seed = 0;
};

struct Interval {
  double low = 0;
  double high = 0;
  friend bool operator==(const Interval&, const Interval&) = default;
};

/// Intervals of P, R and F1. Estimates and truths are drawn independently of each other. Undefined
/// where the score is.
struct DetectionIntervals {
  std::optional<Interval> precision;
  std::optional<Interval> recall;
  std::optional<Interval> f1;
};
/// The three by name, for tables and plots that show all of them.
struct NamedDetectionScore {
  const char* name;
  const char* title;
  DetectionScore value;
  std::optional<Interval> DetectionIntervals::*interval;
};
inline constexpr NamedDetectionScore kDetectionScores[] = {
    {"precision", "precision", precision, &DetectionIntervals::precision},
    {"recall", "recall", recall, &DetectionIntervals::recall},
    {"f1", "F1", f1, &DetectionIntervals::f1},
};

DetectionIntervals bootstrapDetection(const CountsByClass& counts, Averaging averaging,
                                      const BootstrapConfig& config);

/// Interval of mean(values, averaging); undefined where the mean is.
std::optional<Interval> bootstrapMean(const ValuesByClass& values, Averaging averaging,
                                      const BootstrapConfig& config);

/// Does A beat B? Both saw the same truths, so a resample draws truths, and each with what both
/// methods made of it.
struct PairedComparison {
  double difference = 0;  ///< score of A minus score of B
  Interval interval;      ///< of the difference
  /// Two-sided p-value: twice the share of resamples on the far side of 0, (count + 1) / (resamples
  /// + 1), at most 1.
  double p_value = 1;
};

/// What methods A and B scored on one truth (found or not as 1 and 0; valueOfTruth; ...).
struct PairedValue {
  double a = 0;
  double b = 0;
};
using PairedValuesByClass = std::map<Label, std::vector<PairedValue>>;
/// Difference of the means over truths. No truths: undefined.
std::optional<PairedComparison> pairedBootstrap(const PairedValuesByClass& values,
                                                Averaging averaging, const BootstrapConfig& config);

/// Difference in P, R or F1, pooled or averaged over classes: truths are drawn in pairs, the two
/// sets of estimates independently.
struct PairedDetection {
  std::size_t estimates_a = 0;
  std::size_t matched_estimates_a = 0;
  std::size_t estimates_b = 0;
  std::size_t matched_estimates_b = 0;
  std::vector<PairedValue> found;  ///< per truth, 1 or 0
};
std::optional<PairedComparison> pairedBootstrapDetection(
    const std::map<Label, PairedDetection>& classes, DetectionScore detection_score,
    Averaging averaging, const BootstrapConfig& config);

/// Any statistic of a set of objects (a difference of means over those found, a slope): gets the
/// indices of a draw, sum of the stratum sizes many, and says nullopt where they do not define it.
using DrawStatistic = std::function<std::optional<double>(std::span<const std::size_t> drawn)>;
/// Indices count through the strata, 0 to the sum of their sizes less 1, and each stratum is drawn
/// with replacement at its own size. Draws that leave the statistic undefined are left out;
/// undefined where it is so on the data itself. Depends on the order of the objects: sort them.
std::optional<PairedComparison> bootstrapStatistic(std::span<const std::size_t> stratum_sizes,
                                                   const DrawStatistic& statistic,
                                                   const BootstrapConfig& config);

}  // namespace hydrabench

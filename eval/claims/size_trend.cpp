// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/claims/size_trend.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <span>
#include <utility>
#include <vector>

namespace hydrabench {
namespace {

std::vector<double> sizeDeviations(const MethodEvaluation& evaluation) {
  std::map<Label, std::pair<double, std::size_t>> logs;
  std::vector<double> log_sizes;
  for (const ScoredObject& truth : evaluation.truths) {
    log_sizes.push_back(std::log(std::max(truth.detection.half_diagonal, 1e-9)));
    auto& [sum, count] = logs[truth.detection.label];
    sum += log_sizes.back();
    ++count;
  }
  std::vector<double> deviations;
  for (std::size_t t = 0; t < evaluation.truths.size(); ++t) {
    const auto& [sum, count] = logs[evaluation.truths[t].detection.label];
    deviations.push_back(std::abs(log_sizes[t] - sum / static_cast<double>(count)));
  }
  return deviations;
}

/// Least squares through the points of a draw.
std::optional<double> slope(const std::vector<double>& deviations,
                            const std::vector<std::optional<double>>& values,
                            const MethodEvaluation& evaluation, const TruthStrata& strata,
                            std::span<const std::size_t> drawn) {
  struct Sums {
    double n = 0, x = 0, y = 0, xx = 0, xy = 0;
  };
  std::map<Label, Sums> classes;
  for (const std::size_t i : drawn) {
    const std::size_t t = strata.truths[i];
    if (!values[t]) continue;
    Sums& s = classes[evaluation.truths[t].detection.label];
    const double x = deviations[t];
    s.n += 1;
    s.x += x;
    s.y += *values[t];
    s.xx += x * x;
    s.xy += x * *values[t];
  }
  double xx = 0;
  double xy = 0;
  for (const auto& [label, s] : classes) {
    xx += s.xx - s.x * s.x / s.n;
    xy += s.xy - s.x * s.y / s.n;
  }
  return xx > 1e-12 ? std::optional(xy / xx) : std::nullopt;
}

}  // namespace

std::optional<PairedComparison> sizeTrend(const MatchedMethod& a, const MatchedMethod* b,
                                          const PairScoreColumn& column,
                                          const BootstrapConfig& config) {
  const MethodEvaluation& evaluation = *a.evaluation;
  const TruthStrata strata(evaluation);
  const std::vector<double> deviations = sizeDeviations(evaluation);
  const auto values_a = valuesOfFound(a, column);
  std::vector<std::optional<double>> values_b;
  if (b) values_b = valuesOfFound(*b, column);
  return bootstrapStatistic(
      strata.sizes,
      [&](std::span<const std::size_t> drawn) -> std::optional<double> {
        const auto slope_a = slope(deviations, values_a, evaluation, strata, drawn);
        if (!b || !slope_a) return slope_a;
        const auto slope_b = slope(deviations, values_b, evaluation, strata, drawn);
        return slope_b ? std::optional(*slope_a - *slope_b) : std::nullopt;
      },
      config);
}

}  // namespace hydrabench

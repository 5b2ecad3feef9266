// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "metrics/count_recovery.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace hydrabench {
namespace {

constexpr double kSlack = 1e-9;  // decimal digits are no binary fractions

double harmonicMean(double a, double b) { return a + b > 0 ? 2 * a * b / (a + b) : 0; }

}  // namespace

std::optional<RatioFit> fitRatio(const PrintedScore& printed, std::size_t total) {
  if (total == 0 || !(printed.value >= 0 && printed.value <= 1)) return std::nullopt;
  const auto n = static_cast<double>(total);
  const double count = std::clamp(std::round(printed.value * n), 0.0, n);
  const double error = std::abs(count / n - printed.value);
  if (error > printed.unit - kSlack) return std::nullopt;
  return RatioFit{static_cast<std::size_t>(count), error > printed.unit / 2 + kSlack};
}

std::vector<TotalFit> fitTotals(std::span<const PrintedScore> ratios, std::size_t max_total) {
  std::vector<TotalFit> fits;
  for (std::size_t total = 1; total <= max_total; ++total) {
    TotalFit fit = {total, 0};
    const bool all = std::all_of(ratios.begin(), ratios.end(), [&](const PrintedScore& printed) {
      const std::optional<RatioFit> ratio = fitRatio(printed, total);
      if (ratio && ratio->off) ++fit.off;
      return ratio.has_value();
    });
    if (all) fits.push_back(fit);
  }
  std::stable_sort(fits.begin(), fits.end(),
                   [](const TotalFit& a, const TotalFit& b) { return a.off < b.off; });
  return fits;
}

bool f1Follows(const PrintedScore& precision, const PrintedScore& recall, const PrintedScore& f1) {
  const auto bound = [&](double sign) {
    const auto at = [&](const PrintedScore& s) {
      return std::clamp(s.value + sign * s.unit, 0.0, 1.0);
    };
    return harmonicMean(at(precision), at(recall)) + sign * f1.unit / 2;
  };
  return f1.value >= bound(-1) - kSlack && f1.value <= bound(1) + kSlack;
}

}  // namespace hydrabench

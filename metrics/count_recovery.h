// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace hydrabench {

// The counts behind printed scores. A precision printed as .787 is a whole number of estimates over
// a whole number of estimates; few pairs of small numbers round to it, and several scores over one
// total leave hardly any (Brown and Heathers' GRIM test, for ratios).

/// A score as a table prints it: rounded to a multiple of `unit`.
struct PrintedScore {
  double value = 0;
  double unit = 0.001;
};

/// count / total, as near to a printed score as a whole count gets.
struct RatioFit {
  std::size_t count = 0;
  bool off = false;  ///< it rounds to the printed score only upwards or downwards, not to nearest
};
/// nullopt where no count comes within one unit of the printed score.
std::optional<RatioFit> fitRatio(const PrintedScore& printed, std::size_t total);

/// A total that all scores printed over it can have.
struct TotalFit {
  std::size_t total = 0;
  std::size_t off = 0;  ///< how many of the scores are RatioFit::off
};
/// All totals up to `max_total`, those with the fewest scores off first, small before large.
std::vector<TotalFit> fitTotals(std::span<const PrintedScore> ratios, std::size_t max_total);

/// Whether F1 = 2 P R / (P + R) can be what is printed, by P and R as printed or as they were
/// before rounding.
bool f1Follows(const PrintedScore& precision, const PrintedScore& recall, const PrintedScore& f1);

}  // namespace hydrabench

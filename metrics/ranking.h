// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include "metrics/bootstrap.h"

namespace hydrabench {

/// What one method made of one world.
struct WorldOutcome {
  std::size_t estimates = 0;
  std::size_t matched_estimates = 0;
  std::vector<char> found;  ///< per truth, in the same order for every method
};

/// above[a][b]: how likely method a has the higher F1 (all classes pooled) than b on another draw
/// of worlds and of objects in them; a tie counts one half, the diagonal is 1/2. Two-stage
/// bootstrap (Davison and Hinkley 1997, ch. 3.8): worlds are drawn with replacement, then in each
/// drawn world its truths, with what every method made of them, and each method's estimates.
/// Undefined F1 (no truths, no estimates) counts as 0.
/// @param methods  per method its outcome in each world, the worlds in the same order
std::vector<std::vector<double>> rankProbabilities(
    const std::vector<std::vector<WorldOutcome>>& methods, const BootstrapConfig& config);

/// p-values adjusted so that rejecting all below alpha errs anywhere in the family with at most
/// probability alpha (Holm, Scand. J. Statist. 1979): p_(i) times (n - i + 1), made monotone, at
/// most 1. In the order given.
std::vector<double> holmAdjusted(const std::vector<double>& p_values);

}  // namespace hydrabench

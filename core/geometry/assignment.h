// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include <Eigen/Core>

namespace hydrabench {

/// Pairs (row, column), ascending by row.
using Assignment = std::vector<std::pair<std::size_t, std::size_t>>;

/// Minimum-cost assignment of min(R, C) pairs in an R x C cost matrix (shortest augmenting paths,
/// Jonker and Volgenant 1987). Costs must be finite.
Assignment assignMinCost(const Eigen::MatrixXd& cost);

/// Largest number of pairs whose cost is finite; among those of the smallest total cost; among
/// those the lexicographically smallest list of pairs, so that the answer is unique. Infinity marks
/// a forbidden pair.
/// Costs are compared in whole numbers of 2^-52 of the largest one: sums are exact, ties are ties.
Assignment assignGated(const Eigen::MatrixXd& cost);

}  // namespace hydrabench

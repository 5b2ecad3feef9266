// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cctype>
#include <limits>

#include "core/config/config_reader.h"

namespace hydrabench {
namespace {

/// Case and the kind of dash are not what one misspells.
std::string folded(std::string_view word) {
  std::string result(word);
  for (char& c : result) {
    c = c == '-' ? '_' : static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  }
  return result;
}

/// Optimal string alignment: insertions, deletions, substitutions and swaps of neighbours.
std::size_t editDistance(const std::string& a, const std::string& b) {
  std::vector<std::vector<std::size_t>> cost(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
  for (std::size_t i = 0; i <= a.size(); ++i) {
    for (std::size_t j = 0; j <= b.size(); ++j) {
      if (i == 0 || j == 0) {
        cost[i][j] = i + j;
        continue;
      }
      cost[i][j] = std::min({cost[i - 1][j] + 1, cost[i][j - 1] + 1,
                             cost[i - 1][j - 1] + (a[i - 1] == b[j - 1] ? 0u : 1u)});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) {
        cost[i][j] = std::min(cost[i][j], cost[i - 2][j - 2] + 1);
      }
    }
  }
  return cost[a.size()][b.size()];
}

}  // namespace

std::string didYouMean(std::string_view word, const std::vector<std::string>& known) {
  const std::string typed = folded(word);
  if (typed.size() > 100) return "";
  std::string best;
  std::size_t best_distance = std::numeric_limits<std::size_t>::max();
  for (const std::string& candidate : known) {
    const std::string target = folded(candidate);
    const std::size_t distance = editDistance(typed, target);
    // A missing or superfluous unit ("max_range" for "max_range_m") is the commonest slip of all.
    const bool unit_slip = typed.size() >= 4 && target.size() >= 4 &&
                           (target.starts_with(typed + "_") || typed.starts_with(target + "_"));
    const std::size_t allowed = std::max<std::size_t>(1, target.size() / 3);
    if ((distance <= allowed || unit_slip) && distance < best_distance) {
      best = candidate;
      best_distance = distance;
    }
  }
  return best;
}

}  // namespace hydrabench

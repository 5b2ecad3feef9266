// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "metrics/ranking.h"

#include <algorithm>
#include <cassert>
#include <numeric>

#include "core/types/random.h"

namespace hydrabench {
namespace {

/// F1 of every method on one draw.
std::vector<double> drawnScores(const std::vector<std::vector<WorldOutcome>>& methods,
                                Random random) {
  const std::size_t num_worlds = methods.front().size();
  std::vector<DetectionCounts> counts(methods.size());
  for (std::size_t i = 0; i < num_worlds; ++i) {
    const std::size_t world = random.index(static_cast<std::uint32_t>(num_worlds));
    const std::size_t truths = methods.front()[world].found.size();
    for (std::size_t t = 0; t < truths; ++t) {
      const std::size_t truth = random.index(static_cast<std::uint32_t>(truths));
      for (std::size_t m = 0; m < methods.size(); ++m) {
        counts[m].found_truths += methods[m][world].found[truth] != 0;
      }
    }
    for (std::size_t m = 0; m < methods.size(); ++m) {
      const WorldOutcome& outcome = methods[m][world];
      counts[m].truths += truths;
      counts[m].estimates += outcome.estimates;
      for (std::size_t e = 0; e < outcome.estimates; ++e) {
        counts[m].matched_estimates +=
            random.index(static_cast<std::uint32_t>(outcome.estimates)) < outcome.matched_estimates;
      }
    }
  }
  std::vector<double> scores;
  for (const DetectionCounts& of_method : counts) scores.push_back(f1(of_method).value_or(0));
  return scores;
}

}  // namespace

std::vector<std::vector<double>> rankProbabilities(
    const std::vector<std::vector<WorldOutcome>>& methods, const BootstrapConfig& config) {
  const std::size_t count = methods.size();
  std::vector<std::vector<double>> above(count, std::vector<double>(count, 0.5));
  if (count == 0 || methods.front().empty() || config.resamples == 0) return above;
  std::vector<std::vector<std::size_t>> halves(count, std::vector<std::size_t>(count, 0));
  for (int i = 0; i < config.resamples; ++i) {
    const std::vector<double> scores =
        drawnScores(methods, Random(config.seed, static_cast<std::uint64_t>(i)));
    for (std::size_t a = 0; a < count; ++a) {
      for (std::size_t b = 0; b < count; ++b) {
        halves[a][b] += scores[a] > scores[b] ? 2 : scores[a] == scores[b] ? 1 : 0;
      }
    }
  }
  for (std::size_t a = 0; a < count; ++a) {
    for (std::size_t b = 0; b < count; ++b) {
      above[a][b] = static_cast<double>(halves[a][b]) / (2.0 * config.resamples);
    }
  }
  return above;
}

std::vector<double> holmAdjusted(const std::vector<double>& p_values) {
  std::vector<std::size_t> order(p_values.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return p_values[a] < p_values[b]; });
  std::vector<double> adjusted(p_values.size());
  double largest = 0;
  for (std::size_t i = 0; i < order.size(); ++i) {
    const auto left = static_cast<double>(order.size() - i);
    largest = std::max(largest, std::min(1.0, left * p_values[order[i]]));
    adjusted[order[i]] = largest;
  }
  return adjusted;
}

}  // namespace hydrabench

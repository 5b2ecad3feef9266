// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/evaluation/expected_counts.h"

#include <algorithm>
#include <optional>
#include <vector>

namespace hydrabench {
namespace {

/// For each estimate, the truths it may stand for.
std::vector<std::vector<std::size_t>> candidates(std::span<const DetectionObject> estimates,
                                                 std::span<const DetectionObject> truths,
                                                 const Threshold& threshold) {
  std::vector<std::vector<std::size_t>> result(estimates.size());
  for (std::size_t e = 0; e < estimates.size(); ++e) {
    for (std::size_t g = 0; g < truths.size(); ++g) {
      if (estimates[e].label != truths[g].label) continue;
      const double distance = (estimates[e].center - truths[g].center).norm();
      if (threshold.admits(distance, truths[g])) result[e].push_back(g);
    }
  }
  return result;
}

class Pairing {
 public:
  Pairing(const std::vector<std::vector<std::size_t>>& candidates, std::size_t truths)
      : candidates_(candidates), owner_(truths) {
    for (std::size_t e = 0; e < candidates.size(); ++e) {
      visited_.assign(truths, 0);
      place(e);
    }
  }
  const std::vector<std::optional<std::size_t>>& ownerOfTruth() const { return owner_; }

 private:
  /// Gives `estimate` a truth, moving others aside if need be.
  bool place(std::size_t estimate) {
    for (const std::size_t truth : candidates_[estimate]) {
      if (visited_[truth]) continue;
      visited_[truth] = 1;
      if (!owner_[truth] || place(*owner_[truth])) {
        owner_[truth] = estimate;
        return true;
      }
    }
    return false;
  }

  const std::vector<std::vector<std::size_t>>& candidates_;
  std::vector<std::optional<std::size_t>> owner_;
  std::vector<char> visited_;
};

}  // namespace

CountsByClass expectedCounts(std::span<const DetectionObject> estimates,
                             std::span<const DetectionObject> truths, Matching matching,
                             const Threshold& threshold) {
  CountsByClass counts;
  for (const DetectionObject& object : estimates) ++counts[object.label].estimates;
  for (const DetectionObject& object : truths) ++counts[object.label].truths;
  const auto of_estimate = candidates(estimates, truths, threshold);
  if (matching == Matching::kOneToOne) {
    const Pairing pairing(of_estimate, truths.size());
    for (std::size_t g = 0; g < truths.size(); ++g) {
      if (!pairing.ownerOfTruth()[g]) continue;
      ++counts[truths[g].label].found_truths;
      ++counts[truths[g].label].matched_estimates;
    }
    return counts;
  }
  std::vector<char> found(truths.size(), 0);
  for (std::size_t e = 0; e < estimates.size(); ++e) {
    if (!of_estimate[e].empty()) ++counts[estimates[e].label].matched_estimates;
    for (const std::size_t g : of_estimate[e]) found[g] = 1;
  }
  for (std::size_t g = 0; g < truths.size(); ++g) {
    if (found[g]) ++counts[truths[g].label].found_truths;
  }
  return counts;
}

}  // namespace hydrabench

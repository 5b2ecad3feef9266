// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "metrics/detection.h"

namespace hydrabench {

/// Indices into the spans that were matched.
struct MatchedPair {
  std::size_t estimate = 0;
  std::size_t truth = 0;
  friend auto operator<=>(const MatchedPair&, const MatchedPair&) = default;
};

/// Who belongs to whom. Depends on labels, centres, extents and ids only, never on the order of the
/// input.
struct DetectionMatches {
  Matching matching = Matching::kExists;
  /// Per estimate. exists: its nearest same-label truth inside the gate. one_to_one: the assigned
  /// truth.
  std::vector<std::optional<std::size_t>> truth_of_estimate;
  /// Per truth. exists: the nearest same-label estimate inside the gate, which may itself be nearer
  /// to another truth. one_to_one: the assigned estimate.
  std::vector<std::optional<std::size_t>> estimate_of_truth;
  /// Estimates without a partner inside the gate of a truth that another one took; ascending. Empty
  /// under exists, where they match.
  std::vector<std::size_t> duplicates;
  /// Truths with more than one estimate inside the gate; ascending.
  std::vector<std::size_t> ambiguous_truths;
};

/// Each side looks for its nearest same-label partner strictly inside the gate; equal distances:
/// the smaller id.
DetectionMatches matchExists(std::span<const DetectionObject> estimates,
                             std::span<const DetectionObject> truths, const Threshold& threshold);

/// As many pairs as possible; among those the smallest sum of distances; among those the pairs of
/// the smallest ids.
DetectionMatches matchOneToOne(std::span<const DetectionObject> estimates,
                               std::span<const DetectionObject> truths, const Threshold& threshold);

DetectionMatches match(Matching matching, std::span<const DetectionObject> estimates,
                       std::span<const DetectionObject> truths, const Threshold& threshold);

DetectionCounts counts(const DetectionMatches& matches);
/// One entry for every label that occurs in either set; they sum to counts(matches).
CountsByClass countsByClass(const DetectionMatches& matches,
                            std::span<const DetectionObject> estimates,
                            std::span<const DetectionObject> truths);

/// Pairs whose geometry the paper's means run over: every matched estimate with its truth;
/// ascending.
std::vector<MatchedPair> matchedPairs(const DetectionMatches& matches);
/// Every pair that any mean needs: matchedPairs() and each found truth with its estimate;
/// ascending, no pair twice.
std::vector<MatchedPair> pairsToScore(const DetectionMatches& matches);

}  // namespace hydrabench

// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "eval/evaluation/evaluator.h"
#include "metrics/bootstrap.h"
#include "metrics/matching.h"
#include "metrics/pair_scores.h"

namespace hydrabench {

/// A method on one world or several (merged, pooled), matched at one threshold. Refers to the
/// evaluation.
struct MatchedMethod {
  const MethodEvaluation* evaluation = nullptr;
  DetectionMatches matches;

  bool found(std::size_t truth) const { return matches.estimate_of_truth[truth].has_value(); }
  /// Of the estimate that a truth was matched with; null where it was missed or the pair was not
  /// scored.
  const PairScores* scores(std::size_t truth) const;
  std::optional<double> score(DetectionScore detection_score) const {
    return detection_score(counts(matches));
  }
};

MatchedMethod matchedMethod(const MethodEvaluation& evaluation, const Threshold& threshold,
                            Matching matching);

/// Whether the same truths stand in the same order in both: only then can methods be paired.
bool sameTruths(const MethodEvaluation& a, const MethodEvaluation& b);

/// P, R or F1 of `a` less that of `b`, pooled over classes; exactly 0 where both said the same.
/// Undefined where a score is. Both have the same truths.
std::optional<PairedComparison> compareDetection(const MatchedMethod& a, const MatchedMethod& b,
                                                 DetectionScore detection_score,
                                                 const BootstrapConfig& config);

/// Mean of a pair score over the truths that were found; nullopt where none was.
std::optional<double> meanOfFound(const MatchedMethod& method, const PairScoreColumn& column);

/// That mean of `a` less that of `b`, each over what it found itself; truths are drawn in pairs.
std::optional<PairedComparison> compareFound(const MatchedMethod& a, const MatchedMethod& b,
                                             const PairScoreColumn& column,
                                             const BootstrapConfig& config);

/// The truths by class: strata for bootstrapStatistic(), whose indices count through `truths`.
struct TruthStrata {
  std::vector<std::size_t> truths;
  std::vector<std::size_t> sizes;
  explicit TruthStrata(const MethodEvaluation& evaluation);
};
/// Per truth what the estimate matched with it scored.
std::vector<std::optional<double>> valuesOfFound(const MatchedMethod& method,
                                                 const PairScoreColumn& column);

}  // namespace hydrabench

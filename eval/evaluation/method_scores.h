// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "eval/evaluation/evaluator.h"
#include "eval/evaluation/score_rows.h"

namespace hydrabench {

std::vector<DetectionObject> detections(const std::vector<ScoredObject>& objects);

/// Matches at every threshold of the config under both semantics.
std::vector<ThresholdMatches> matchAtThresholds(const std::vector<DetectionObject>& estimates,
                                                const std::vector<DetectionObject>& truths,
                                                const EvaluationConfig& config);

/// Fills scores, objects and kappa_curves from the estimates, truths and pair scores that are
/// there.
void fillScores(const EvaluationConfig& config, const std::vector<ThresholdMatches>& matches,
                MethodEvaluation& evaluation);

/// Matches and fills anew, for other thresholds of detection or other intervals. Every pair that is
/// matched at one of config.thresholds_m needs its scores.
void rescore(const EvaluationConfig& config, MethodEvaluation& evaluation);

/// Objects and pair scores of one method on several worlds in one; no scores yet.
MethodEvaluation merged(std::span<const MethodEvaluation* const> worlds);

/// One method on several worlds as a whole, seed "pooled": objects are matched within their own
/// world, then counted and averaged together. The worlds must be those of one dataset.
MethodEvaluation pooled(std::span<const MethodEvaluation* const> worlds,
                        const EvaluationConfig& config);

}  // namespace hydrabench

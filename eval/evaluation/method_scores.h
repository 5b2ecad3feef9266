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
/// Index of the nearest object of the same class in the same world; nullopt where there is none.
std::optional<std::size_t> nearestOfClass(const DetectionObject& object,
                                          const std::vector<DetectionObject>& candidates);

/// Matches at every threshold of the config under both semantics.
std::vector<ThresholdMatches> matchAtThresholds(const std::vector<DetectionObject>& estimates,
                                                const std::vector<DetectionObject>& truths,
                                                const EvaluationConfig& config);

/// Fills scores, objects and kappa_curves from the estimates, truths and pair scores that are
/// there.
void fillScores(const LabelSpace& label_space, const EvaluationConfig& config,
                const std::vector<ThresholdMatches>& matches, MethodEvaluation& evaluation);

/// One method on several worlds as a whole, seed "pooled": objects are matched within their own
/// world, then counted and averaged together. The worlds must be those of one dataset.
MethodEvaluation pooled(std::span<const MethodEvaluation* const> worlds,
                        const LabelSpace& label_space, const EvaluationConfig& config);

}  // namespace hydrabench

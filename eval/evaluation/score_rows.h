// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <string>
#include <vector>

#include "eval/evaluation/evaluator.h"
#include "metrics/matching.h"

namespace hydrabench {

/// Who matched whom at one threshold.
struct ThresholdMatches {
  Threshold threshold;
  DetectionMatches matches;
  bool with_geometry = true;  ///< pair scores exist for these matches
};

/// What every row of one evaluation has in common.
struct ScoreContext {
  const std::string& dataset;
  const std::string& seed;
  const std::string& method;
  const LabelSpace& label_space;
  const EvaluationConfig& config;
};

/// Rows of scores.csv for all thresholds: per class, pooled (all_micro) and averaged over classes
/// (all_macro).
std::vector<ScoreRow> scoreRows(const ScoreContext& context, const MethodEvaluation& evaluation,
                                const std::vector<ThresholdMatches>& matches,
                                const std::map<MatchedPair, PairScores>& pair_scores);

/// One exact sweep per class and pooled, under both semantics.
std::vector<KappaCurve> kappaCurves(const ScoreContext& context,
                                    const std::vector<DetectionObject>& estimates,
                                    const std::vector<DetectionObject>& truths);
std::vector<ScoreRow> kappaAreaRows(const ScoreContext& context,
                                    const std::vector<KappaCurve>& curves);

}  // namespace hydrabench

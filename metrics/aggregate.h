// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <span>
#include <vector>

#include "metrics/detection.h"
#include "metrics/pair_scores.h"

namespace hydrabench {

/// A mean says how many values it stands on and how many had to stay out.
struct Mean {
  std::optional<double> value;  ///< undefined without values
  std::size_t n = 0;            ///< values (macro: classes) in the mean
  std::size_t undefined =
      0;  ///< values (macro: classes) that are undefined and therefore not in it
};

enum class Averaging {
  kMicro,  ///< every object weighs the same
  kMacro,  ///< every class that has ground truth weighs the same
};

/// The values of one score in one class, ascending, so that no order of the input reaches a sum.
struct ClassSample {
  std::vector<double> values;
  std::size_t undefined = 0;
};
/// An entry for every class that has ground truth, also where it holds no value.
using ValuesByClass = std::map<Label, ClassSample>;

/// A matched pair with the class of its truth.
struct PairOutcome {
  Label label = kUnknownLabel;
  PairScores scores;
};
/// A truth and what became of it.
struct TruthOutcome {
  Label label = kUnknownLabel;
  double half_diagonal = 0;  ///< d_diag [m]
  bool has_surface = true;   ///< false: nothing can be said of its geometry
  std::optional<PairScores>
      scores;  ///< against its estimate (DetectionMatches::estimate_of_truth); nullopt: missed
};

/// Over matched pairs, as in the paper. Rewards missing hard objects, so print it beside the next
/// one.
/// @param truths  name the classes that have ground truth
ValuesByClass valuesOverPairs(std::span<const PairOutcome> pairs,
                              std::span<const TruthOutcome> truths, const PairScoreColumn& column);
/// Over all ground truth: a miss, and an estimate for which the score is undefined, count with
/// column.worst(); found ones are capped by it. A truth without a surface is undefined. Not for
/// reference columns (all undefined).
ValuesByClass valuesOverTruths(std::span<const TruthOutcome> truths, const PairScoreColumn& column);
/// The value one truth adds to valuesOverTruths; what a paired comparison of two methods resamples.
std::optional<double> valueOfTruth(const TruthOutcome& truth, const PairScoreColumn& column);

Mean mean(const ClassSample& sample);
/// Micro: all values pooled. Macro: the mean of the class means; a class without values is
/// undefined, left out and counted.
Mean mean(const ValuesByClass& values, Averaging averaging);

/// Micro: the score of the summed counts, of which n is the number of estimates (precision), truths
/// (recall) or both (f1) and undefined is 0. Macro: the mean of the class scores over classes with
/// ground truth; estimates of other classes count in micro only. Macro F1 is the mean of the class
/// F1s, which never exceeds both macro P and macro R.
Mean score(const CountsByClass& counts, DetectionScore detection_score, Averaging averaging);

}  // namespace hydrabench

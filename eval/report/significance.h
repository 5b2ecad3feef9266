// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "eval/evaluation/evaluator.h"
#include "metrics/bootstrap.h"

namespace hydrabench {

/// How sure it is that one method scores differently from another on the same worlds: both saw the
/// same ground truth, so a resample draws objects with what each method made of them. Matching is
/// one_to_one: under `exists` one estimate can stand for several objects, and what an object scored
/// is not its own.
struct PairedDifference {
  std::string dataset;
  std::string seed;  ///< of the one world, or "pooled"
  double threshold_m = 0;
  std::string metric;  ///< f1, or the mean over all ground truth of b_iou, v_iou_solid, chamfer_l1
  std::string method_a;
  std::string method_b;
  double value_a = 0;
  double value_b = 0;
  PairedComparison comparison;  ///< of a less b
  double p_holm = 1;            ///< adjusted over all pairs of this dataset, threshold and metric
  std::optional<double> above;  ///< of F1: how likely a ranks above b (rankProbabilities())
};

/// Every pair of methods on every dataset, the one with the higher F1 first; the worlds of a
/// dataset together. Methods that lack a world are left out.
std::vector<PairedDifference> pairedDifferences(const std::vector<MethodEvaluation>& evaluations,
                                                const EvaluationConfig& config);

/// Of each method but the last in F1: how likely it ranks above the next; metric rank_stability.
std::vector<ScoreRow> rankStabilityRows(const std::vector<PairedDifference>& differences);

std::string significanceCsv(const std::vector<PairedDifference>& differences);
/// Methods by their F1, each against the next.
std::string significanceMarkdown(const std::vector<PairedDifference>& differences);

/// What is found and how well, by how much of an object was ever in view; one_to_one.
struct Stratum {
  std::string dataset;
  double threshold_m = 0;
  std::string method;
  double from = 0;  ///< visible fraction, inclusive; `to` is exclusive but for 1
  double to = 1;
  std::size_t truths = 0;
  std::size_t found = 0;
  std::optional<Interval> recall;
  std::optional<double> b_iou;  ///< means over the found
  std::optional<double> v_iou;
};
std::vector<Stratum> strata(const std::vector<MethodEvaluation>& evaluations,
                            const EvaluationConfig& config);
std::string strataCsv(const std::vector<Stratum>& strata);
std::string strataMarkdown(const std::vector<Stratum>& strata);

}  // namespace hydrabench

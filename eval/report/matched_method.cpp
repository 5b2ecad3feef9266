// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/report/matched_method.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <span>

#include "eval/evaluation/method_scores.h"

namespace hydrabench {
namespace {

/// Then they differ on no draw. Labels read from two files may be numbered differently.
bool sameAnswers(const MatchedMethod& a, const MatchedMethod& b) {
  return a.matches.truth_of_estimate == b.matches.truth_of_estimate &&
         std::equal(a.evaluation->estimates.begin(), a.evaluation->estimates.end(),
                    b.evaluation->estimates.begin(), b.evaluation->estimates.end(),
                    [](const ScoredObject& x, const ScoredObject& y) {
                      return x.class_name == y.class_name &&
                             x.detection.center == y.detection.center;
                    });
}

/// Mean of the values that are there.
std::optional<double> meanOver(const std::vector<std::optional<double>>& values,
                               const std::vector<std::size_t>& truths,
                               std::span<const std::size_t> drawn) {
  double sum = 0;
  std::size_t count = 0;
  for (const std::size_t i : drawn) {
    if (const auto& value = values[truths[i]]) {
      sum += *value;
      ++count;
    }
  }
  return count == 0 ? std::nullopt : std::optional(sum / static_cast<double>(count));
}

}  // namespace

const PairScores* MatchedMethod::scores(std::size_t truth) const {
  const auto& estimate = matches.estimate_of_truth[truth];
  if (!estimate) return nullptr;
  const auto found = evaluation->pair_scores.find({*estimate, truth});
  return found == evaluation->pair_scores.end() ? nullptr : &found->second;
}

MatchedMethod matchedMethod(const MethodEvaluation& evaluation, const Threshold& threshold,
                            Matching matching) {
  return {&evaluation, match(matching, detections(evaluation.estimates),
                             detections(evaluation.truths), threshold)};
}

bool sameTruths(const MethodEvaluation& a, const MethodEvaluation& b) {
  return std::equal(a.truths.begin(), a.truths.end(), b.truths.begin(), b.truths.end(),
                    [](const ScoredObject& x, const ScoredObject& y) {
                      return x.detection.id == y.detection.id &&
                             x.detection.world == y.detection.world;
                    });
}

std::optional<PairedComparison> compareDetection(const MatchedMethod& a, const MatchedMethod& b,
                                                 DetectionScore detection_score,
                                                 const BootstrapConfig& config) {
  if (sameAnswers(a, b)) return PairedComparison{};
  std::map<Label, PairedDetection> classes;
  for (std::size_t t = 0; t < a.evaluation->truths.size(); ++t) {
    classes[a.evaluation->truths[t].detection.label].found.push_back(
        {a.found(t) ? 1.0 : 0.0, b.found(t) ? 1.0 : 0.0});
  }
  for (std::size_t e = 0; e < a.evaluation->estimates.size(); ++e) {
    PairedDetection& of_class = classes[a.evaluation->estimates[e].detection.label];
    ++of_class.estimates_a;
    of_class.matched_estimates_a += a.matches.truth_of_estimate[e].has_value();
  }
  for (std::size_t e = 0; e < b.evaluation->estimates.size(); ++e) {
    PairedDetection& of_class = classes[b.evaluation->estimates[e].detection.label];
    ++of_class.estimates_b;
    of_class.matched_estimates_b += b.matches.truth_of_estimate[e].has_value();
  }
  return pairedBootstrapDetection(classes, detection_score, Averaging::kMicro, config);
}

TruthStrata::TruthStrata(const MethodEvaluation& evaluation) {
  std::map<Label, std::vector<std::size_t>> classes;
  for (std::size_t t = 0; t < evaluation.truths.size(); ++t) {
    classes[evaluation.truths[t].detection.label].push_back(t);
  }
  for (const auto& [label, of_class] : classes) {
    truths.insert(truths.end(), of_class.begin(), of_class.end());
    sizes.push_back(of_class.size());
  }
}

std::vector<std::optional<double>> valuesOfFound(const MatchedMethod& method,
                                                 const PairScoreColumn& column) {
  std::vector<std::optional<double>> values(method.evaluation->truths.size());
  for (std::size_t t = 0; t < values.size(); ++t) {
    if (const PairScores* scores = method.scores(t)) values[t] = scores->*column.value;
  }
  return values;
}

std::optional<double> meanOfFound(const MatchedMethod& method, const PairScoreColumn& column) {
  const auto values = valuesOfFound(method, column);
  std::vector<std::size_t> all(values.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  return meanOver(values, all, all);
}

std::optional<PairedComparison> compareFound(const MatchedMethod& a, const MatchedMethod& b,
                                             const PairScoreColumn& column,
                                             const BootstrapConfig& config) {
  const TruthStrata strata(*a.evaluation);
  const auto values_a = valuesOfFound(a, column);
  const auto values_b = valuesOfFound(b, column);
  return bootstrapStatistic(
      strata.sizes,
      [&](std::span<const std::size_t> drawn) -> std::optional<double> {
        const auto mean_a = meanOver(values_a, strata.truths, drawn);
        const auto mean_b = meanOver(values_b, strata.truths, drawn);
        if (!mean_a || !mean_b) return std::nullopt;
        return *mean_a - *mean_b;
      },
      config);
}

}  // namespace hydrabench

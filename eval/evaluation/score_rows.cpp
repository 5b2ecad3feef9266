// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/evaluation/score_rows.h"

#include <algorithm>
#include <functional>
#include <set>
#include <utility>

#include "core/parallel/parallel_for.h"
#include "metrics/aggregate.h"
#include "metrics/bootstrap.h"

namespace hydrabench {
namespace {

/// A class, or all classes pooled or averaged.
struct Scope {
  std::string name;
  std::optional<Label> label;  ///< nullopt: all
  Averaging averaging = Averaging::kMicro;

  bool holds(Label object_label) const { return !label || *label == object_label; }
};

std::vector<Scope> scopes(const ScoreContext& context, const std::set<Label>& labels) {
  std::vector<Scope> result = {{kAllMicro, {}, Averaging::kMicro},
                               {kAllMacro, {}, Averaging::kMacro}};
  for (const Label label : labels) {
    result.push_back({context.label_space.nameOf(label), label, Averaging::kMicro});
  }
  return result;
}

ScoreRow blankRow(const ScoreContext& context, const Scope& scope, const ThresholdMatches& at,
                  std::string metric) {
  ScoreRow row;
  row.dataset = context.dataset;
  row.seed = context.seed;
  row.method = context.method;
  row.class_name = scope.name;
  row.threshold_kind = name(at.threshold.kind);
  row.threshold = at.threshold.value;
  row.matching = name(at.matches.matching);
  row.metric = std::move(metric);
  return row;
}

void setInterval(ScoreRow& row, const std::optional<Interval>& interval) {
  if (!interval) return;
  row.ci95_low = interval->low;
  row.ci95_high = interval->high;
}

void appendDetectionRows(const ScoreContext& context, const Scope& scope,
                         const ThresholdMatches& at, const MethodEvaluation& evaluation,
                         const CountsByClass& all_counts, std::vector<ScoreRow>& rows) {
  CountsByClass counts;
  DetectionCounts total;
  for (const auto& [label, value] : all_counts) {
    if (!scope.holds(label)) continue;
    counts.emplace(label, value);
    total += value;
  }
  DetectionIntervals intervals;
  if (context.config.bootstrap_resamples > 0) {
    intervals = bootstrapDetection(counts, scope.averaging, context.config.bootstrapConfig());
  }
  const auto add = [&](const char* metric, DetectionScore detection_score,
                       const std::optional<Interval>& interval) {
    const Mean mean = score(counts, detection_score, scope.averaging);
    ScoreRow row = blankRow(context, scope, at, metric);
    row.value = mean.value;
    row.n = mean.n;
    setInterval(row, interval);
    rows.push_back(std::move(row));
  };
  add("precision", precision, intervals.precision);
  add("recall", recall, intervals.recall);
  add("f1", f1, intervals.f1);

  const auto inScope = [&](const std::vector<std::size_t>& indices,
                           const std::vector<ScoredObject>& objects) {
    return static_cast<std::size_t>(
        std::count_if(indices.begin(), indices.end(),
                      [&](std::size_t i) { return scope.holds(objects[i].detection.label); }));
  };
  const std::pair<const char*, std::size_t> tallies[] = {
      {"estimates", total.estimates},
      {"matched_estimates", total.matched_estimates},
      {"truths", total.truths},
      {"found_truths", total.found_truths},
      {"duplicates", inScope(at.matches.duplicates, evaluation.estimates)},
      {"ambiguous_truths", inScope(at.matches.ambiguous_truths, evaluation.truths)},
  };
  if (scope.averaging == Averaging::kMacro) return;  // counts have no mean over classes
  for (const auto& [metric, count] : tallies) {
    ScoreRow row = blankRow(context, scope, at, metric);
    row.value = static_cast<double>(count);
    row.unit = "count";
    row.n = count;
    rows.push_back(std::move(row));
  }
}

void appendGeometryRows(const ScoreContext& context, const Scope& scope, const ThresholdMatches& at,
                        const MethodEvaluation& evaluation,
                        const std::map<MatchedPair, PairScores>& pair_scores,
                        std::vector<ScoreRow>& rows) {
  std::vector<PairOutcome> pairs;
  for (const MatchedPair& pair : matchedPairs(at.matches)) {
    const Label label = evaluation.truths[pair.truth].detection.label;
    if (scope.holds(label)) pairs.push_back({label, pair_scores.at(pair)});
  }
  std::vector<TruthOutcome> truths;
  for (std::size_t g = 0; g < evaluation.truths.size(); ++g) {
    const ScoredObject& truth = evaluation.truths[g];
    if (!scope.holds(truth.detection.label)) continue;
    TruthOutcome outcome{
        truth.detection.label, truth.detection.half_diagonal, truth.has_surface, {}};
    if (const auto estimate = at.matches.estimate_of_truth[g]) {
      outcome.scores = pair_scores.at({*estimate, g});
    }
    truths.push_back(std::move(outcome));
  }
  const auto add = [&](std::string metric, const PairScoreColumn& column,
                       const ValuesByClass& values) {
    const Mean average = mean(values, scope.averaging);
    ScoreRow row = blankRow(context, scope, at, std::move(metric));
    row.value = average.value;
    row.n = average.n;
    row.unit = column.unit == "1" ? "" : std::string(column.unit);
    if (context.config.bootstrap_resamples > 0) {
      setInterval(row, bootstrapMean(values, scope.averaging, context.config.bootstrapConfig()));
    }
    rows.push_back(std::move(row));
  };
  for (const PairScoreColumn& column : pairScoreColumns()) {
    add(std::string(column.name), column, valuesOverPairs(pairs, truths, column));
    if (column.direction == ScoreDirection::kReference) continue;
    add(std::string(column.name) + "_all_gt", column, valuesOverTruths(truths, column));
  }
}

}  // namespace

std::vector<ScoreRow> scoreRows(const ScoreContext& context, const MethodEvaluation& evaluation,
                                const std::vector<ThresholdMatches>& matches,
                                const std::map<MatchedPair, PairScores>& pair_scores) {
  std::set<Label> labels;
  std::vector<DetectionObject> estimates;
  std::vector<DetectionObject> truths;
  for (const ScoredObject& object : evaluation.estimates) estimates.push_back(object.detection);
  for (const ScoredObject& object : evaluation.truths) truths.push_back(object.detection);
  for (const DetectionObject& object : estimates) labels.insert(object.label);
  for (const DetectionObject& object : truths) labels.insert(object.label);
  const std::vector<Scope> all_scopes = scopes(context, labels);

  std::vector<std::vector<ScoreRow>> parts(matches.size() * all_scopes.size());
  parallelFor(parts.size(), [&](std::size_t i) {
    const ThresholdMatches& at = matches[i / all_scopes.size()];
    const Scope& scope = all_scopes[i % all_scopes.size()];
    appendDetectionRows(context, scope, at, evaluation,
                        countsByClass(at.matches, estimates, truths), parts[i]);
    if (at.with_geometry) {
      appendGeometryRows(context, scope, at, evaluation, pair_scores, parts[i]);
    }
  });
  std::vector<ScoreRow> rows;
  for (std::vector<ScoreRow>& part : parts) {
    std::move(part.begin(), part.end(), std::back_inserter(rows));
  }
  return rows;
}

std::vector<KappaCurve> kappaCurves(const ScoreContext& context,
                                    const std::vector<DetectionObject>& estimates,
                                    const std::vector<DetectionObject>& truths) {
  std::set<Label> labels;
  for (const DetectionObject& object : estimates) labels.insert(object.label);
  for (const DetectionObject& object : truths) labels.insert(object.label);
  std::vector<KappaCurve> curves;
  for (const Scope& scope : scopes(context, labels)) {
    if (scope.averaging == Averaging::kMacro) continue;
    const auto chosen = [&](const std::vector<DetectionObject>& objects) {
      std::vector<DetectionObject> result;
      std::copy_if(objects.begin(), objects.end(), std::back_inserter(result),
                   [&](const DetectionObject& object) { return scope.holds(object.label); });
      return result;
    };
    const std::vector<DetectionObject> scope_estimates = chosen(estimates);
    const std::vector<DetectionObject> scope_truths = chosen(truths);
    for (const Matching matching : {Matching::kExists, Matching::kOneToOne}) {
      curves.push_back({scope.name, sweepKappa(scope_estimates, scope_truths, matching)});
    }
  }
  return curves;
}

std::vector<ScoreRow> kappaAreaRows(const ScoreContext& context,
                                    const std::vector<KappaCurve>& curves) {
  std::vector<ScoreRow> rows;
  for (const KappaCurve& curve : curves) {
    ScoreRow row;
    row.dataset = context.dataset;
    row.seed = context.seed;
    row.method = context.method;
    row.class_name = curve.class_name;
    row.threshold_kind = "kappa";
    row.threshold = context.config.kappa_max;
    row.matching = name(curve.sweep.matching);
    row.metric = "f1_kappa_auc";
    const DetectionCounts counts = curve.sweep.at(context.config.kappa_max);
    if (const auto area = areaUnderF1(curve.sweep, context.config.kappa_max)) {
      row.value = *area / context.config.kappa_max;
    }
    row.n = counts.estimates + counts.truths;
    rows.push_back(std::move(row));
  }
  // The area is linear, so the macro area is the mean of the areas of the classes with ground
  // truth.
  for (const Matching matching : {Matching::kExists, Matching::kOneToOne}) {
    ScoreRow macro = rows.front();
    macro.class_name = kAllMacro;
    macro.matching = name(matching);
    macro.n = 0;
    double sum = 0;
    for (std::size_t i = 0; i < curves.size(); ++i) {
      const KappaSweep& sweep = curves[i].sweep;
      if (curves[i].class_name == kAllMicro || sweep.matching != matching ||
          sweep.at(0).truths == 0)
        continue;
      sum += rows[i].value.value_or(0);
      ++macro.n;
    }
    macro.value = sum / static_cast<double>(macro.n);
    rows.push_back(std::move(macro));
  }
  return rows;
}

}  // namespace hydrabench

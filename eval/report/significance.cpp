// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/report/significance.h"

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <utility>

#include <fmt/format.h>

#include "core/parallel/parallel_for.h"
#include "eval/evaluation/csv.h"
#include "eval/evaluation/method_scores.h"
#include "eval/report/comparison_table.h"
#include "eval/report/matched_method.h"
#include "metrics/aggregate.h"
#include "metrics/ranking.h"

namespace hydrabench {
namespace {

constexpr std::array<const char*, 3> kPairScores = {"b_iou", "v_iou_solid", "chamfer_l1"};
constexpr std::array<double, 5> kStrata = {0, 0.25, 0.5, 0.75, 1};

/// The evaluations that stand for each dataset: pooled ones where there are several worlds.
std::vector<std::vector<const MethodEvaluation*>> byDataset(
    const std::vector<MethodEvaluation>& evaluations) {
  std::set<std::string> pooled;
  for (const MethodEvaluation& evaluation : evaluations) {
    if (evaluation.seed == kPooledSeed) pooled.insert(evaluation.dataset);
  }
  std::vector<std::vector<const MethodEvaluation*>> datasets;
  std::map<std::string, std::size_t> index;
  for (const MethodEvaluation& evaluation : evaluations) {
    if (pooled.contains(evaluation.dataset) && evaluation.seed != kPooledSeed) continue;
    const auto [place, is_new] = index.emplace(evaluation.dataset, datasets.size());
    if (is_new) datasets.emplace_back();
    datasets[place->second].push_back(&evaluation);
  }
  return datasets;
}

std::vector<WorldOutcome> worldOutcomes(const MatchedMethod& method) {
  std::size_t num_worlds = 0;
  for (const ScoredObject& truth : method.evaluation->truths) {
    num_worlds = std::max<std::size_t>(num_worlds, truth.detection.world + 1);
  }
  std::vector<WorldOutcome> worlds(num_worlds);
  for (std::size_t t = 0; t < method.evaluation->truths.size(); ++t) {
    worlds[method.evaluation->truths[t].detection.world].found.push_back(method.found(t) ? 1 : 0);
  }
  for (std::size_t e = 0; e < method.evaluation->estimates.size(); ++e) {
    const std::uint32_t world = method.evaluation->estimates[e].detection.world;
    if (world >= num_worlds) continue;  // a world without truths
    ++worlds[world].estimates;
    worlds[world].matched_estimates += method.matches.truth_of_estimate[e].has_value();
  }
  return worlds;
}

TruthOutcome outcomeOf(const MatchedMethod& method, std::size_t truth) {
  const ScoredObject& object = method.evaluation->truths[truth];
  TruthOutcome outcome;
  outcome.label = object.detection.label;
  outcome.half_diagonal = object.detection.half_diagonal;
  outcome.has_surface = object.has_surface;
  if (const PairScores* scores = method.scores(truth)) outcome.scores = *scores;
  return outcome;
}

/// Values per truth, and their means.
struct PairedScores {
  PairedValuesByClass values;
  double mean_a = 0;
  double mean_b = 0;
};
PairedScores pairedScores(const MatchedMethod& a, const MatchedMethod& b,
                          const PairScoreColumn& column) {
  PairedScores result;
  std::size_t count = 0;
  for (std::size_t t = 0; t < a.evaluation->truths.size(); ++t) {
    const auto value_a = valueOfTruth(outcomeOf(a, t), column);
    const auto value_b = valueOfTruth(outcomeOf(b, t), column);
    if (!value_a || !value_b) continue;
    result.values[a.evaluation->truths[t].detection.label].push_back({*value_a, *value_b});
    result.mean_a += *value_a;
    result.mean_b += *value_b;
    ++count;
  }
  if (count > 0) {
    result.mean_a /= static_cast<double>(count);
    result.mean_b /= static_cast<double>(count);
  }
  return result;
}

/// All pairs of methods on one dataset at one threshold, in one metric after the other.
std::vector<PairedDifference> pairsAt(const std::vector<const MethodEvaluation*>& evaluations,
                                      double threshold_m, const EvaluationConfig& config) {
  std::vector<MatchedMethod> methods;
  for (const MethodEvaluation* evaluation : evaluations) {
    if (sameTruths(*evaluation, *evaluations.front())) {
      methods.push_back(
          matchedMethod(*evaluation, Threshold::tau(threshold_m), Matching::kOneToOne));
    }
  }
  std::stable_sort(
      methods.begin(), methods.end(),
      [](const MatchedMethod& a, const MatchedMethod& b) { return a.score(f1) > b.score(f1); });
  std::vector<std::pair<std::size_t, std::size_t>> pairs;
  for (std::size_t a = 0; a < methods.size(); ++a) {
    for (std::size_t b = a + 1; b < methods.size(); ++b) pairs.emplace_back(a, b);
  }
  const BootstrapConfig bootstrap = config.bootstrapConfig();
  std::vector<std::vector<WorldOutcome>> outcomes;
  for (const MatchedMethod& method : methods) outcomes.push_back(worldOutcomes(method));
  const auto above = rankProbabilities(outcomes, bootstrap);

  std::vector<PairedDifference> all;
  for (std::size_t k = 0; k <= kPairScores.size(); ++k) {
    std::vector<std::optional<PairedDifference>> of_metric(pairs.size());
    parallelFor(pairs.size(), [&](std::size_t i) {
      const MatchedMethod& a = methods[pairs[i].first];
      const MatchedMethod& b = methods[pairs[i].second];
      PairedDifference difference;
      difference.dataset = a.evaluation->dataset;
      difference.seed = a.evaluation->seed;
      difference.threshold_m = threshold_m;
      difference.method_a = a.evaluation->method;
      difference.method_b = b.evaluation->method;
      std::optional<PairedComparison> comparison;
      if (k == 0) {
        difference.metric = "f1";
        difference.value_a = a.score(f1).value_or(0);
        difference.value_b = b.score(f1).value_or(0);
        difference.above = above[pairs[i].first][pairs[i].second];
        comparison = compareDetection(a, b, f1, bootstrap);
      } else {
        const PairScoreColumn& column = *findPairScoreColumn(kPairScores[k - 1]);
        difference.metric = std::string(column.name) + "_all_gt";
        const PairedScores scores = pairedScores(a, b, column);
        difference.value_a = scores.mean_a;
        difference.value_b = scores.mean_b;
        comparison = pairedBootstrap(scores.values, Averaging::kMicro, bootstrap);
      }
      if (!comparison) return;
      difference.comparison = *comparison;
      of_metric[i] = std::move(difference);
    });
    std::vector<PairedDifference> family;
    std::vector<double> p_values;
    for (auto& difference : of_metric) {
      if (!difference) continue;
      p_values.push_back(difference->comparison.p_value);
      family.push_back(std::move(*difference));
    }
    const std::vector<double> adjusted = holmAdjusted(p_values);
    for (std::size_t i = 0; i < family.size(); ++i) family[i].p_holm = adjusted[i];
    std::move(family.begin(), family.end(), std::back_inserter(all));
  }
  return all;
}

/// Of every method but the last in F1 the comparison with the next.
std::vector<const PairedDifference*> againstNext(const std::vector<PairedDifference>& differences) {
  std::vector<const PairedDifference*> result;
  for (const PairedDifference& d : differences) {
    if (d.metric != "f1") continue;
    // Pairs come ordered by the F1 of the first, then of the second method.
    const bool is_first = result.empty() || result.back()->dataset != d.dataset ||
                          result.back()->threshold_m != d.threshold_m;
    if (is_first || d.method_a == result.back()->method_b) result.push_back(&d);
  }
  return result;
}

std::string pText(double p) { return p < 0.001 ? "< 0.001" : fmt::format("{:.3f}", p); }

std::string share(std::size_t part, std::size_t whole) {
  return whole == 0 ? "n/a"
                    : fmt::format("{:.2f}", static_cast<double>(part) / static_cast<double>(whole));
}

std::string number(const std::optional<double>& value) {
  return value ? fmt::format("{:.3f}", *value) : "n/a";
}

}  // namespace

std::vector<PairedDifference> pairedDifferences(const std::vector<MethodEvaluation>& evaluations,
                                                const EvaluationConfig& config) {
  std::vector<PairedDifference> all;
  if (config.bootstrap_resamples == 0) return all;
  for (const auto& dataset : byDataset(evaluations)) {
    for (const double threshold : config.thresholds_m) {
      for (PairedDifference& difference : pairsAt(dataset, threshold, config)) {
        all.push_back(std::move(difference));
      }
    }
  }
  return all;
}

std::string significanceCsv(const std::vector<PairedDifference>& differences) {
  std::string text = csvLine({"dataset", "threshold_m", "matching", "metric", "method_a",
                              "method_b", "value_a", "value_b", "difference", "difference_ci95_low",
                              "difference_ci95_high", "p", "p_holm", "probability_a_above_b"});
  for (const PairedDifference& d : differences) {
    text += csvLine({d.dataset, csvNumber(d.threshold_m), kMatchingOneToOne, d.metric, d.method_a,
                     d.method_b, csvNumber(d.value_a), csvNumber(d.value_b),
                     csvNumber(d.comparison.difference), csvNumber(d.comparison.interval.low),
                     csvNumber(d.comparison.interval.high), csvNumber(d.comparison.p_value),
                     csvNumber(d.p_holm), csvNumber(d.above)});
  }
  return text;
}

std::vector<ScoreRow> rankStabilityRows(const std::vector<PairedDifference>& differences) {
  std::vector<ScoreRow> rows;
  for (const PairedDifference* d : againstNext(differences)) {
    ScoreRow& row = rows.emplace_back();
    row.dataset = d->dataset;
    row.seed = d->seed;
    row.method = d->method_a;
    row.class_name = kAllMicro;
    row.threshold_kind = name(Threshold::Kind::kTauM);
    row.threshold = d->threshold_m;
    row.matching = kMatchingOneToOne;
    row.metric = "rank_stability";
    row.value = d->above;
  }
  return rows;
}

std::string significanceMarkdown(const std::vector<PairedDifference>& differences) {
  std::string text;
  std::string heading;
  for (const PairedDifference* next : againstNext(differences)) {
    const PairedDifference& d = *next;
    const std::string here =
        fmt::format("### {}, tau_d = {:g} m, one_to_one", d.dataset, d.threshold_m);
    if (here != heading) {
      heading = here;
      text += fmt::format(
          "{}{}\n\n| method | F1 | the next | F1 above it by | p | p (Holm) | ranks above it |\n"
          "|---|---:|---|---|---:|---:|---:|\n",
          text.empty() ? "" : "\n", here);
    }
    text +=
        fmt::format("| {} | {:.3f} | {} | {:.3f} [{:.3f}, {:.3f}] | {} | {} | {:.3f} |\n",
                    methodLabel(d.method_a), d.value_a, methodLabel(d.method_b),
                    d.comparison.difference, d.comparison.interval.low, d.comparison.interval.high,
                    pText(d.comparison.p_value), pText(d.p_holm), d.above.value_or(0.5));
  }
  return text +
         "\np: paired bootstrap over objects, two-sided; Holm: adjusted over all pairs of the "
         "block. "
         "ranks above it: probability under resampling of worlds and of objects in them. Every "
         "pair, and the means over all ground truth: significance.csv.\n";
}

std::vector<Stratum> strata(const std::vector<MethodEvaluation>& evaluations,
                            const EvaluationConfig& config) {
  std::vector<Stratum> result;
  for (const auto& dataset : byDataset(evaluations)) {
    for (const double threshold : config.thresholds_m) {
      for (const MethodEvaluation* evaluation : dataset) {
        const MatchedMethod method =
            matchedMethod(*evaluation, Threshold::tau(threshold), Matching::kOneToOne);
        for (std::size_t s = 0; s + 1 < kStrata.size(); ++s) {
          Stratum stratum{evaluation->dataset,
                          threshold,
                          evaluation->method,
                          kStrata[s],
                          kStrata[s + 1],
                          0,
                          0,
                          {},
                          {},
                          {}};
          std::vector<double> b_iou, v_iou;
          ValuesByClass hits;
          for (std::size_t t = 0; t < evaluation->truths.size(); ++t) {
            const double visible = evaluation->truths[t].visible_fraction.value_or(1);
            const bool last = s + 2 == kStrata.size();
            if (visible < stratum.from || (visible >= stratum.to && !last)) continue;
            ++stratum.truths;
            stratum.found += method.found(t);
            ClassSample& sample = hits[0];
            sample.values.push_back(method.found(t) ? 1 : 0);
            if (const PairScores* scores = method.scores(t)) {
              if (scores->b_iou) b_iou.push_back(*scores->b_iou);
              if (scores->v_iou_solid) v_iou.push_back(*scores->v_iou_solid);
            }
          }
          const auto mean_of = [](const std::vector<double>& values) -> std::optional<double> {
            if (values.empty()) return std::nullopt;
            double sum = 0;
            for (const double value : values) sum += value;
            return sum / static_cast<double>(values.size());
          };
          stratum.b_iou = mean_of(b_iou);
          stratum.v_iou = mean_of(v_iou);
          if (config.bootstrap_resamples > 0 && stratum.truths > 0) {
            std::sort(hits[0].values.begin(), hits[0].values.end());
            stratum.recall = bootstrapMean(hits, Averaging::kMicro, config.bootstrapConfig());
          }
          result.push_back(std::move(stratum));
        }
      }
    }
  }
  return result;
}

std::string strataCsv(const std::vector<Stratum>& strata) {
  std::string text = csvLine({"dataset", "threshold_m", "matching", "method", "visible_from",
                              "visible_to", "truths", "found_truths", "recall", "recall_ci95_low",
                              "recall_ci95_high", "b_iou", "v_iou_solid"});
  for (const Stratum& s : strata) {
    const std::optional<double> recall =
        s.truths == 0 ? std::nullopt
                      : std::optional(static_cast<double>(s.found) / static_cast<double>(s.truths));
    text += csvLine(
        {s.dataset, csvNumber(s.threshold_m), kMatchingOneToOne, s.method, csvNumber(s.from),
         csvNumber(s.to), std::to_string(s.truths), std::to_string(s.found), csvNumber(recall),
         s.recall ? csvNumber(s.recall->low) : "", s.recall ? csvNumber(s.recall->high) : "",
         csvNumber(s.b_iou), csvNumber(s.v_iou)});
  }
  return text;
}

std::string strataMarkdown(const std::vector<Stratum>& strata) {
  std::string text;
  std::string heading;
  for (const Stratum& s : strata) {
    const std::string here =
        fmt::format("### {}, tau_d = {:g} m, one_to_one", s.dataset, s.threshold_m);
    if (here != heading) {
      heading = here;
      text += fmt::format(
          "{}{}\n\n| method | visible | GT | R | B-IoU | V-IoU |\n|---|---|---:|---|---:|---:|\n",
          text.empty() ? "" : "\n", here);
    }
    const std::string interval =
        s.recall ? fmt::format(" [{:.2f}, {:.2f}]", s.recall->low, s.recall->high) : "";
    text += fmt::format("| {} | {:.0f} to {:.0f} % | {} | {}{} | {} | {} |\n",
                        methodLabel(s.method), 100 * s.from, 100 * s.to, s.truths,
                        share(s.found, s.truths), interval, number(s.b_iou), number(s.v_iou));
  }
  return text +
         "\nvisible: share of an object's surface that some frame saw. B-IoU, V-IoU: means over "
         "the found.\n";
}

}  // namespace hydrabench

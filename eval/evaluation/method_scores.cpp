// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/evaluation/method_scores.h"

#include <algorithm>
#include <cassert>
#include <utility>

#include "eval/evaluation/scene_rows.h"

namespace hydrabench {
namespace {

/// Rows of objects.csv at one threshold: estimates in order, then misses.
void appendObjectRows(const DetectionMatches& matches, const Threshold& threshold,
                      const std::map<MatchedPair, PairScores>& pair_scores,
                      const std::vector<DetectionObject>& estimates,
                      const std::vector<DetectionObject>& truths, std::vector<ObjectRow>& rows) {
  const auto distance = [&](std::size_t estimate, std::size_t truth) {
    return (estimates[estimate].center - truths[truth].center).norm();
  };
  for (std::size_t e = 0; e < estimates.size(); ++e) {
    ObjectRow row{threshold, matches.matching, ObjectRow::Outcome::kUnmatched, e, {}, {}, {}};
    row.truth = matches.truth_of_estimate[e];
    if (row.truth) {
      row.outcome = ObjectRow::Outcome::kMatched;
      row.scores = pair_scores.at({e, *row.truth});
    } else {
      row.truth = nearestOfClass(estimates[e], truths);
      if (std::binary_search(matches.duplicates.begin(), matches.duplicates.end(), e)) {
        row.outcome = ObjectRow::Outcome::kDuplicate;
      }
    }
    if (row.truth) row.center_distance_m = distance(e, *row.truth);
    rows.push_back(std::move(row));
  }
  for (std::size_t g = 0; g < truths.size(); ++g) {
    if (matches.estimate_of_truth[g]) continue;
    rows.push_back({threshold, matches.matching, ObjectRow::Outcome::kMissed, {}, g, {}, {}});
  }
}

}  // namespace

std::vector<DetectionObject> detections(const std::vector<ScoredObject>& objects) {
  std::vector<DetectionObject> result;
  result.reserve(objects.size());
  for (const ScoredObject& object : objects) result.push_back(object.detection);
  return result;
}

std::vector<ThresholdMatches> matchAtThresholds(const std::vector<DetectionObject>& estimates,
                                                const std::vector<DetectionObject>& truths,
                                                const EvaluationConfig& config) {
  std::vector<ThresholdMatches> matches;
  const auto add = [&](const Threshold& threshold, bool with_geometry) {
    for (const Matching matching : {Matching::kExists, Matching::kOneToOne}) {
      matches.push_back({threshold, match(matching, estimates, truths, threshold), with_geometry});
    }
  };
  for (const double tau : config.thresholds_m) add(Threshold::tau(tau), true);
  for (const double kappa : config.kappas) add(Threshold::kappa(kappa), false);
  return matches;
}

void fillScores(const EvaluationConfig& config, const std::vector<ThresholdMatches>& matches,
                MethodEvaluation& evaluation) {
  const ScoreContext context{evaluation.dataset, evaluation.seed, evaluation.method,
                             evaluation.label_space, config};
  const std::vector<DetectionObject> estimates = detections(evaluation.estimates);
  const std::vector<DetectionObject> truths = detections(evaluation.truths);
  evaluation.scores = scoreRows(context, evaluation, matches, evaluation.pair_scores);
  evaluation.kappa_curves = kappaCurves(context, estimates, truths);
  for (const ScoreRow& row : kappaAreaRows(context, evaluation.kappa_curves)) {
    evaluation.scores.push_back(row);
  }
  for (const ScoreRow& row : sceneRows(context, evaluation.scene)) {
    evaluation.scores.push_back(row);
  }
  for (const ThresholdMatches& at : matches) {
    if (at.with_geometry) {
      appendObjectRows(at.matches, at.threshold, evaluation.pair_scores, estimates, truths,
                       evaluation.objects);
    }
  }
}

void rescore(const EvaluationConfig& config, MethodEvaluation& evaluation) {
  evaluation.objects.clear();
  fillScores(
      config,
      matchAtThresholds(detections(evaluation.estimates), detections(evaluation.truths), config),
      evaluation);
}

MethodEvaluation merged(std::span<const MethodEvaluation* const> worlds) {
  assert(!worlds.empty());
  MethodEvaluation all;
  all.dataset = worlds.front()->dataset;
  all.seed = kPooledSeed;
  all.method = worlds.front()->method;
  all.label_space = worlds.front()->label_space;
  for (std::size_t w = 0; w < worlds.size(); ++w) {
    const MethodEvaluation& world = *worlds[w];
    assert(world.dataset == all.dataset && world.method == all.method);
    const std::size_t first_estimate = all.estimates.size();
    const std::size_t first_truth = all.truths.size();
    const auto append = [&](const std::vector<ScoredObject>& from, std::vector<ScoredObject>& to) {
      for (const ScoredObject& object : from) {
        to.push_back(object);
        to.back().detection.world = static_cast<std::uint32_t>(w);
      }
    };
    append(world.estimates, all.estimates);
    append(world.truths, all.truths);
    for (const auto& [pair, scores] : world.pair_scores) {
      all.pair_scores.emplace(MatchedPair{first_estimate + pair.estimate, first_truth + pair.truth},
                              scores);
    }
    all.scene.insert(all.scene.end(), world.scene.begin(), world.scene.end());
    all.unscored_estimates += world.unscored_estimates;
    for (DetectionObject object : world.ignored) {
      object.world = static_cast<std::uint32_t>(w);
      all.ignored.push_back(object);
    }
    all.estimates_without_mesh += world.estimates_without_mesh;
  }
  return all;
}

MethodEvaluation pooled(std::span<const MethodEvaluation* const> worlds,
                        const EvaluationConfig& config) {
  MethodEvaluation all = merged(worlds);
  rescore(config, all);
  return all;
}

}  // namespace hydrabench

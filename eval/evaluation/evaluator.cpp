// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/evaluation/evaluator.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include <fmt/format.h>

#include "core/parallel/parallel_for.h"
#include "core/types/error.h"
#include "eval/evaluation/score_rows.h"
#include "metrics/matching.h"

namespace hydrabench {
namespace {

std::vector<DetectionObject> detections(const std::vector<ScoredObject>& objects) {
  std::vector<DetectionObject> result;
  result.reserve(objects.size());
  for (const ScoredObject& object : objects) result.push_back(object.detection);
  return result;
}

/// Centre and size are those of the box of the mesh; an object without a mesh is known by its box
/// alone.
ScoredObject scoredObject(ObjectId id, Label label, const std::string& name, const Aabb& box,
                          std::shared_ptr<const ObjectModel> model) {
  ScoredObject object;
  object.detection = {id, label, box.center(), halfDiagonal(box)};
  object.name = name;
  object.box = box;
  object.model = std::move(model);
  return object;
}

PairScores scoresOf(const ScoredObject& estimate, const ScoredObject& truth) {
  PairScores scores = scorePair(*estimate.model, *truth.model);
  if (!estimate.model->hasSurface()) {
    scores.b_iou = boxIou(estimate.box, truth.box);
    const auto oriented = [](const Aabb& box) {
      OrientedBox result;
      result.T_world_box.translation() = box.center();
      result.dimensions = box.sizes();
      return result;
    };
    scores.obb_iou = orientedBoxIou(oriented(estimate.box), truth.model->orientedBox());
  }
  return scores;
}

/// Index of the nearest object of the same label; nullopt where there is none.
std::optional<std::size_t> nearestOf(const DetectionObject& object,
                                     const std::vector<DetectionObject>& candidates) {
  std::optional<std::size_t> nearest;
  double nearest_distance = 0;
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    if (candidates[i].label != object.label) continue;
    const double distance = (candidates[i].center - object.center).norm();
    if (!nearest || distance < nearest_distance) {
      nearest = i;
      nearest_distance = distance;
    }
  }
  return nearest;
}

double medianHalfDiagonal(const std::vector<ScoredObject>& objects) {
  std::vector<double> sizes;
  for (const ScoredObject& object : objects) sizes.push_back(object.detection.half_diagonal);
  std::nth_element(sizes.begin(), sizes.begin() + static_cast<std::ptrdiff_t>(sizes.size() / 2),
                   sizes.end());
  return sizes[sizes.size() / 2];
}

void requireSameUnits(const std::string& method, const std::vector<ScoredObject>& estimates,
                      const std::vector<ScoredObject>& truths) {
  if (estimates.empty()) return;
  const double ratio = medianHalfDiagonal(estimates) / medianHalfDiagonal(truths);
  if (ratio > 100) {
    throw InputError(
        fmt::format("prediction '{}': objects are {:.0f} times as large as the ground truth, "
                    "expected metres (are they in millimetres?)",
                    method, ratio));
  }
}

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
      row.truth = nearestOf(estimates[e], truths);
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

Evaluator::Evaluator(std::string dataset_name, std::string seed, const LabelSpace& label_space,
                     const GroundTruth& truth, const EvaluationConfig& config)
    : dataset_name_(std::move(dataset_name)),
      seed_(std::move(seed)),
      label_space_(label_space),
      config_(config) {
  std::vector<const GroundTruthObject*> objects;
  for (const GroundTruthObject& object : truth.objects) {
    const LabelSpace::Entry* entry = label_space_.find(object.label);
    if (entry && entry->is_scored) objects.push_back(&object);
  }
  std::vector<ScoredObject> all(objects.size());
  parallelFor(objects.size(), [&](std::size_t i) {
    const GroundTruthObject& object = *objects[i];
    auto model =
        std::make_shared<const ObjectModel>(transformed(object.T_world_object, *object.mesh),
                                            ObjectModel::Role::kTruth, config_.modelConfig());
    if (!model->hasSurface()) {
      throw InputError(
          fmt::format("dataset '{}': ground truth '{}': mesh without a surface, expected triangles",
                      dataset_name_, object.name));
    }
    all[i] = scoredObject(object.id, object.label, object.name, model->box(), model);
    all[i].subtype = object.subtype;
    all[i].room = object.room;
    all[i].visible_fraction = object.visible_fraction;
  });
  for (std::size_t i = 0; i < objects.size(); ++i) {
    if (objects[i]->scored && objects[i]->visible_fraction >= config_.min_visible_fraction) {
      truths_.push_back(std::move(all[i]));
    } else {
      ignored_.push_back(all[i].detection);
    }
  }
  if (truths_.empty()) {
    throw InputError(fmt::format(
        "dataset '{}': ground truth: no object that counts (of {}), expected at least one",
        dataset_name_, truth.objects.size()));
  }
}

MethodEvaluation Evaluator::evaluate(const Prediction& prediction) const {
  MethodEvaluation evaluation;
  evaluation.method = prediction.method;
  evaluation.truths = truths_;
  evaluation.unscored_truths = ignored_.size();

  std::vector<const ObjectNode*> nodes;
  for (const ObjectNode& node : prediction.graph.objects) {
    const LabelSpace::Entry* entry = label_space_.find(node.label);
    if (entry && entry->is_scored) nodes.push_back(&node);
  }
  std::vector<ScoredObject> all(nodes.size());
  parallelFor(nodes.size(), [&](std::size_t i) {
    const ObjectNode& node = *nodes[i];
    auto model = std::make_shared<const ObjectModel>(node.mesh, ObjectModel::Role::kEstimate,
                                                     config_.modelConfig());
    const Aabb& box = node.mesh.empty() ? node.box : model->box();
    if (box.isEmpty()) {
      throw InputError(
          fmt::format("prediction '{}': object {} '{}': neither a mesh nor a bounding box",
                      prediction.method, node.id, node.name));
    }
    all[i] = scoredObject(node.id, node.label, node.name, box, model);
  });
  // An estimate of something that does not count is neither right nor wrong.
  const std::vector<DetectionObject> truths = detections(truths_);
  for (ScoredObject& object : all) {
    const DetectionObject& estimate = object.detection;
    const auto ignored = nearestOf(estimate, ignored_);
    bool excused = false;
    if (ignored) {
      const double distance = (ignored_[*ignored].center - estimate.center).norm();
      const auto counted = nearestOf(estimate, truths);
      excused = distance < ignored_[*ignored].half_diagonal &&
                (!counted || distance < (truths[*counted].center - estimate.center).norm());
    }
    if (!excused) evaluation.estimates.push_back(std::move(object));
  }
  evaluation.unscored_estimates = prediction.graph.objects.size() - evaluation.estimates.size();
  evaluation.estimates_without_mesh = static_cast<std::size_t>(
      std::count_if(evaluation.estimates.begin(), evaluation.estimates.end(),
                    [](const ScoredObject& object) { return !object.model->hasSurface(); }));
  requireSameUnits(prediction.method, evaluation.estimates, evaluation.truths);
  const std::vector<DetectionObject> estimates = detections(evaluation.estimates);

  std::vector<ThresholdMatches> matches;
  std::set<MatchedPair> wanted;
  for (const double tau : config_.thresholds_m) {
    for (const Matching matching : {Matching::kExists, Matching::kOneToOne}) {
      const Threshold threshold = Threshold::tau(tau);
      matches.push_back({threshold, match(matching, estimates, truths, threshold), true});
      for (const MatchedPair& pair : pairsToScore(matches.back().matches)) wanted.insert(pair);
    }
  }
  for (const double kappa : config_.kappas) {
    for (const Matching matching : {Matching::kExists, Matching::kOneToOne}) {
      const Threshold threshold = Threshold::kappa(kappa);
      matches.push_back({threshold, match(matching, estimates, truths, threshold), false});
    }
  }

  const std::vector<MatchedPair> pairs(wanted.begin(), wanted.end());
  std::vector<PairScores> scores(pairs.size());
  parallelFor(pairs.size(), [&](std::size_t i) {
    scores[i] =
        scoresOf(evaluation.estimates[pairs[i].estimate], evaluation.truths[pairs[i].truth]);
  });
  std::map<MatchedPair, PairScores> pair_scores;
  for (std::size_t i = 0; i < pairs.size(); ++i) pair_scores.emplace(pairs[i], scores[i]);

  const ScoreContext context{dataset_name_, seed_, prediction.method, label_space_, config_};
  evaluation.scores = scoreRows(context, evaluation, matches, pair_scores);
  evaluation.kappa_curves = kappaCurves(context, estimates, truths);
  for (const ScoreRow& row : kappaAreaRows(context, evaluation.kappa_curves)) {
    evaluation.scores.push_back(row);
  }
  for (const ThresholdMatches& at : matches) {
    if (at.with_geometry) {
      appendObjectRows(at.matches, at.threshold, pair_scores, estimates, truths,
                       evaluation.objects);
    }
  }
  return evaluation;
}

}  // namespace hydrabench

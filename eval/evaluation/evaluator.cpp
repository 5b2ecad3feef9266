// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/evaluation/evaluator.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include <fmt/format.h>

#include "core/geometry/median.h"
#include "core/parallel/parallel_for.h"
#include "core/types/error.h"
#include "eval/evaluation/method_scores.h"

namespace hydrabench {
namespace {

/// Centre and size are those of the box of the mesh; an object without a mesh is known by its box
/// alone.
ScoredObject scoredObject(ObjectId id, const LabelSpace::Entry& entry, const std::string& name,
                          const Aabb& box, const ObjectModel& model) {
  ScoredObject object;
  object.detection = {id, entry.label, box.center(), halfDiagonal(box)};
  object.class_name = entry.name;
  object.name = name;
  object.box = box;
  object.faces = model.mesh().faces.size();
  object.has_surface = model.hasSurface();
  object.watertight = model.watertight();
  object.signed_volume_m3 = signedVolume(model.mesh());
  return object;
}

PairScores scoresOf(const ScoredObject& estimate, const ObjectModel& estimate_model,
                    const ScoredObject& truth, const ObjectModel& truth_model) {
  PairScores scores = scorePair(estimate_model, truth_model);
  if (!estimate.has_surface) {
    scores.b_iou = boxIou(estimate.box, truth.box);
    const auto oriented = [](const Aabb& box) {
      OrientedBox result;
      result.T_world_box.translation() = box.center();
      result.dimensions = box.sizes();
      return result;
    };
    scores.obb_iou = orientedBoxIou(oriented(estimate.box), truth_model.orientedBox());
  }
  return scores;
}

double medianHalfDiagonal(const std::vector<ScoredObject>& objects) {
  std::vector<double> sizes;
  for (const ScoredObject& object : objects) sizes.push_back(object.detection.half_diagonal);
  return median(std::move(sizes));
}

/// Matching, means and voxels have no answer to a place that is not a number.
void requireFinite(const std::string& method, const ObjectNode& node) {
  const auto finite = [](const Eigen::Vector3d& v) { return v.allFinite(); };
  const bool good = node.mesh.vertices.empty()
                        ? node.box.isEmpty() || (finite(node.box.min()) && finite(node.box.max()))
                        : std::all_of(node.mesh.vertices.begin(), node.mesh.vertices.end(), finite);
  if (good) return;
  throw InputError(
      fmt::format("prediction '{}': object {} '{}': a coordinate is not a finite number", method,
                  node.id, node.name));
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

}  // namespace

Evaluator::Evaluator(std::string dataset_name, std::string seed, const LabelSpace& label_space,
                     const GroundTruth& truth, const EvaluationConfig& config, ModelSource models)
    : dataset_name_(std::move(dataset_name)),
      seed_(std::move(seed)),
      config_(config),
      models_(std::move(models)) {
  if (!models_) {
    models_ = [config](Mesh mesh, ObjectModel::Role role) {
      return std::make_shared<const ObjectModel>(std::move(mesh), role, config.modelConfig());
    };
  }
  counting_.label_space = label_space;
  std::vector<const GroundTruthObject*> objects;
  std::vector<const LabelSpace::Entry*> entries;
  for (const GroundTruthObject& object : truth.objects) {
    const LabelSpace::Entry* entry = label_space.find(object.label);
    if (!entry || !entry->is_scored) continue;
    objects.push_back(&object);
    entries.push_back(entry);
  }
  std::vector<ScoredObject> all(objects.size());
  std::vector<std::shared_ptr<const ObjectModel>> prepared(objects.size());
  parallelFor(objects.size(), [&](std::size_t i) {
    const GroundTruthObject& object = *objects[i];
    auto model =
        models_(transformed(object.T_world_object, *object.mesh), ObjectModel::Role::kTruth);
    if (!model->hasSurface()) {
      throw InputError(
          fmt::format("dataset '{}': ground truth '{}': mesh without a surface, expected triangles",
                      dataset_name_, object.name));
    }
    all[i] = scoredObject(object.id, *entries[i], object.name, model->box(), *model);
    all[i].subtype = object.subtype;
    all[i].room = object.room;
    all[i].visible_fraction = object.visible_fraction;
    prepared[i] = std::move(model);
  });
  for (std::size_t i = 0; i < objects.size(); ++i) {
    if (objects[i]->scored && objects[i]->visible_fraction >= config_.min_visible_fraction) {
      truths_.push_back(std::move(all[i]));
      truth_models_.push_back(std::move(prepared[i]));
    } else {
      counting_.ignored.push_back(all[i].detection);
    }
  }
  counting_.truths = detections(truths_);
  if (config_.scene.enabled) scene_.emplace(truth, label_space, config_.scene);
  if (truths_.empty()) {
    throw InputError(fmt::format(
        "dataset '{}': ground truth: no object that counts (of {}), expected at least one",
        dataset_name_, truth.objects.size()));
  }
}

Counting countingOf(const MethodEvaluation& evaluation) {
  return {evaluation.label_space, detections(evaluation.truths), evaluation.ignored};
}

MethodEvaluation Evaluator::evaluate(const Prediction& prediction, OtherUnits other_units) const {
  MethodEvaluation evaluation;
  evaluation.dataset = dataset_name_;
  evaluation.seed = seed_;
  evaluation.method = prediction.method;
  evaluation.notes = prediction.notes;
  evaluation.truths = truths_;
  evaluation.ignored = counting_.ignored;
  evaluation.label_space = counting_.label_space;

  std::vector<const ObjectNode*> nodes;
  std::vector<const LabelSpace::Entry*> entries;
  for (const ObjectNode& node : prediction.graph.objects) {
    const LabelSpace::Entry* entry = counting_.label_space.find(node.label);
    if (!entry || !entry->is_scored) continue;
    nodes.push_back(&node);
    entries.push_back(entry);
  }
  std::vector<ScoredObject> all(nodes.size());
  std::vector<std::shared_ptr<const ObjectModel>> models(nodes.size());
  parallelFor(nodes.size(), [&](std::size_t i) {
    const ObjectNode& node = *nodes[i];
    requireFinite(prediction.method, node);
    models[i] = models_(node.mesh, ObjectModel::Role::kEstimate);
    const Aabb& box = node.mesh.empty() ? node.box : models[i]->box();
    if (box.isEmpty()) {
      throw InputError(
          fmt::format("prediction '{}': object {} '{}': neither a mesh nor a bounding box",
                      prediction.method, node.id, node.name));
    }
    all[i] = scoredObject(node.id, *entries[i], node.name, box, *models[i]);
  });
  // An estimate of something that does not count is neither right nor wrong.
  std::vector<const ObjectModel*> estimate_models;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (!counting_.includes(all[i].detection)) continue;
    evaluation.estimates.push_back(std::move(all[i]));
    estimate_models.push_back(models[i].get());
  }
  evaluation.unscored_estimates = prediction.graph.objects.size() - evaluation.estimates.size();
  evaluation.estimates_without_mesh = static_cast<std::size_t>(
      std::count_if(evaluation.estimates.begin(), evaluation.estimates.end(),
                    [](const ScoredObject& object) { return !object.has_surface; }));
  if (other_units == OtherUnits::kRefused) {
    requireSameUnits(prediction.method, evaluation.estimates, evaluation.truths);
  }
  if (scene_) evaluation.scene = scene_->evaluate(prediction.graph);
  const std::vector<DetectionObject> estimates = detections(evaluation.estimates);

  const std::vector<ThresholdMatches> matches =
      matchAtThresholds(estimates, counting_.truths, config_);
  std::set<MatchedPair> wanted;
  for (const ThresholdMatches& at : matches) {
    if (!at.with_geometry) continue;
    for (const MatchedPair& pair : pairsToScore(at.matches)) wanted.insert(pair);
  }
  const std::vector<MatchedPair> pairs(wanted.begin(), wanted.end());
  std::vector<PairScores> scores(pairs.size());
  parallelFor(pairs.size(), [&](std::size_t i) {
    const auto [estimate, truth] = pairs[i];
    scores[i] = scoresOf(evaluation.estimates[estimate], *estimate_models[estimate], truths_[truth],
                         *truth_models_[truth]);
  });
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    evaluation.pair_scores.emplace(pairs[i], scores[i]);
  }
  fillScores(config_, matches, evaluation);
  return evaluation;
}

}  // namespace hydrabench

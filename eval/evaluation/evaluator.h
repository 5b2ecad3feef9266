// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/graph/scene_graph.h"
#include "eval/datasets/dataset.h"
#include "eval/evaluation/counting.h"
#include "eval/evaluation/evaluation_config.h"
#include "eval/evaluation/scene_evaluator.h"
#include "eval/evaluation/score_row.h"
#include "metrics/kappa_sweep.h"
#include "metrics/matching.h"
#include "metrics/pair_scores.h"
#include "metrics/scene_tally.h"

namespace hydrabench {

/// An object as it enters scoring, without its surface: results of many worlds stay small.
struct ScoredObject {
  DetectionObject detection;
  std::string class_name;
  std::string name;
  std::string subtype;
  std::string room;
  std::optional<double> visible_fraction;  ///< ground truth only
  Aabb box;                                ///< of the mesh, or what is given in place of one
  std::size_t faces = 0;
  bool has_surface = false;
  bool watertight = false;
  double signed_volume_m3 = 0;  ///< negative for a closed mesh that is turned inside out
};

/// What became of an estimate or of a ground-truth object at one threshold; a line of objects.csv.
struct ObjectRow {
  enum class Outcome { kMatched, kDuplicate, kUnmatched, kMissed };
  Threshold threshold;
  Matching matching = Matching::kExists;
  Outcome outcome = Outcome::kUnmatched;
  std::optional<std::size_t> estimate;  ///< index into estimates; nullopt for a miss
  std::optional<std::size_t> truth;     ///< index into truths: the partner, or for an unmatched
                                        ///< estimate the nearest of its class
  std::optional<double> center_distance_m;
  std::optional<PairScores> scores;  ///< matched only
};

struct KappaCurve {
  std::string class_name;
  KappaSweep sweep;
};

/// Everything known of one prediction on one dataset. Without truths: one that could not be scored,
/// because the dataset has no ground truth.
struct MethodEvaluation {
  bool isScored() const { return !truths.empty(); }

  std::string dataset;
  std::string seed;  ///< of the dataset; "pooled" for several worlds together
  std::string method;
  LabelSpace label_space;
  std::vector<ScoredObject> estimates;
  std::vector<ScoredObject> truths;
  std::vector<DetectionObject> ignored;           ///< ground truth that is neither found nor missed
  std::map<MatchedPair, PairScores> pair_scores;  ///< of every pair that some mean needs
  std::vector<ScoreRow> scores;
  std::vector<ObjectRow> objects;
  std::vector<KappaCurve> kappa_curves;
  /// Of the map as a whole, per square of the ground plan; empty unless it is scored.
  std::vector<SceneTally> scene;
  std::size_t unscored_estimates =
      0;  ///< of classes that do not count, or nearest to ignored ground truth
  std::vector<std::string> notes;          ///< what a reader of the table must know of the method
  std::size_t estimates_without_mesh = 0;  ///< found by their box; only box scores
};

/// What counted in an evaluation.
Counting countingOf(const MethodEvaluation& evaluation);

/// Ground truth prepared once for scoring any number of predictions against it.
class Evaluator {
 public:
  /// Prepares a mesh with the evaluator's config; called from several threads.
  using ModelSource = std::function<std::shared_ptr<const ObjectModel>(Mesh, ObjectModel::Role)>;

  /// Throws InputError if no object of the ground truth counts, and for one without a surface.
  /// @param models  empty: every mesh is prepared when it comes. For whoever scores the same meshes
  ///                thousands of times.
  Evaluator(std::string dataset_name, std::string seed, const LabelSpace& label_space,
            const GroundTruth& truth, const EvaluationConfig& config, ModelSource models = {});

  enum class OtherUnits { kRefused, kScoredAsIs };
  /// Throws InputError for a prediction that is plainly in other units (millimetres) unless told to
  /// score it as it is, for a coordinate that is not finite, and for an object with neither mesh
  /// nor box.
  MethodEvaluation evaluate(const Prediction& prediction,
                            OtherUnits other_units = OtherUnits::kRefused) const;

  const std::vector<ScoredObject>& truths() const { return truths_; }

 private:
  std::string dataset_name_;
  std::string seed_;
  EvaluationConfig config_;
  ModelSource models_;
  std::vector<ScoredObject> truths_;
  std::vector<std::shared_ptr<const ObjectModel>> truth_models_;
  Counting counting_;
  std::optional<SceneEvaluator> scene_;
};

}  // namespace hydrabench

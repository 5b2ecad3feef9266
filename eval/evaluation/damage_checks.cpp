// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/evaluation/damage_checks.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "core/types/error.h"
#include "eval/evaluation/damage.h"
#include "eval/evaluation/expected_counts.h"
#include "eval/evaluation/submission_check.h"

namespace hydrabench {
namespace {

constexpr double kRounding_m = 1e-9;     ///< of coordinates that were moved
constexpr double kRatioRounding = 1e-6;  ///< of boxes with such corners, thin ones included

/// v in no special direction, so that no symmetry of a layout or an object hides it.
Eigen::Vector3d oblique(double length) { return length * Eigen::Vector3d(3, -4, 12) / 13; }

class DamageChecks {
 public:
  DamageChecks(const Evaluator& evaluator, const EvaluationConfig& config,
               const LabelSpace& label_space, const GroundTruth& truth, const Prediction& perfect,
               const AddCheck& add)
      : evaluator_(evaluator),
        config_(config),
        label_space_(label_space),
        truth_(truth),
        perfect_(perfect),
        add_(add) {}

  void run() {
    checkEmpty();
    checkDoubled();
    checkMerged();
    checkMovedALittle();
    checkAtTheGate();
    checkMovedFar();
    checkInsideOut();
    checkNotANumber();
    checkMistakes();
  }

 private:
  void checkEmpty() {
    const DamagedPrediction damaged = emptied(perfect_);
    const MethodEvaluation scored = evaluator_.evaluate(damaged.prediction);
    ignored_ = scored.ignored;
    std::string fault = wrongRows(scored, "precision", "", std::nullopt);
    if (fault.empty()) fault = wrongRows(scored, "recall", "", 0.0);
    if (fault.empty()) fault = wrongRows(scored, "v_iou_solid_all_gt", "", 0.0);
    if (fault.empty()) fault = countFault(scored, damaged);
    add_("an empty prediction: P undefined, R = 0, V-IoU over all ground truth = 0", fault, "");
  }

  void checkDoubled() {
    const DamagedPrediction damaged = doubled(perfect_);
    const MethodEvaluation scored = evaluator_.evaluate(damaged.prediction);
    std::string fault = wrongRows(scored, "precision", kMatchingExists, 1.0);
    if (fault.empty()) fault = wrongRows(scored, "precision", kMatchingOneToOne, 0.5);
    if (fault.empty()) fault = wrongRows(scored, "recall", "", 1.0);
    if (fault.empty()) fault = countFault(scored, damaged);
    add_("everything twice: P stays 1 under exists and halves under one_to_one", fault, "");
  }

  void checkMerged() {
    const MergedPrediction damaged = merged(perfect_);
    const MethodEvaluation scored = evaluator_.evaluate(damaged.prediction);
    std::string fault = countFault(scored, damaged);
    std::size_t pairs = 0;
    for (const ObjectRow& row : scored.objects) {
      if (!row.scores || !fault.empty()) continue;
      const ScoredObject& truth = scored.truths[*row.truth];
      const ScoredObject& joint = scored.estimates[*row.estimate];
      if (!isPartOf(truth, joint, damaged)) continue;
      ++pairs;
      const double volumes = truth.box.volume() / joint.box.volume();
      if (row.scores->completeness != 0.0) {
        fault = fmt::format("{}: completeness = {}", truth.name, *row.scores->completeness);
      } else if (std::abs(*row.scores->b_iou - volumes) > kRatioRounding) {
        fault = fmt::format("{}: b_iou = {}, expected {}", truth.name, *row.scores->b_iou, volumes);
      }
    }
    add_(
        "the two closest of every class as one object: P and R follow from the centres, "
        "completeness of a part = 0, b_iou = quotient of the boxes",
        fault,
        fmt::format("{} joined, {} pairs with a part inside the gate", damaged.joins.size(),
                    pairs));
  }

  static bool isPartOf(const ScoredObject& truth, const ScoredObject& joint,
                       const MergedPrediction& damaged) {
    for (const MergedPrediction::Join& join : damaged.joins) {
      if (damaged.prediction.graph.objects[join.node].id != joint.detection.id) continue;
      for (const DetectionObject& part : join.parts) {
        if (part.center == truth.detection.center) return true;
      }
    }
    return false;
  }

  void checkMovedALittle() {
    const double length = 0.25 * smallestGate();
    const Eigen::Vector3d v = oblique(length);
    const DamagedPrediction damaged = changed(perfect_, {Eigen::Matrix3d::Identity(), v});
    const MethodEvaluation scored = evaluator_.evaluate(damaged.prediction);
    std::string fault = wrongRows(scored, "precision", "", 1.0);
    if (fault.empty()) fault = wrongRows(scored, "recall", "", 1.0);
    if (fault.empty()) fault = countFault(scored, damaged);
    for (const ObjectRow& row : scored.objects) {
      if (!row.scores || !fault.empty()) continue;
      const ScoredObject& truth = scored.truths[*row.truth];
      const auto report = [&](const char* what, double value, double expected) {
        fault = fmt::format("{}: {} = {}, expected {}", truth.name, what, value, expected);
      };
      const Eigen::Vector3d size = truth.box.sizes();
      const double common = (size - v.cwiseAbs()).cwiseMax(0).prod();
      const double b_iou = common / (2 * size.prod() - common);
      if (std::abs(*row.center_distance_m - length) > kRounding_m) {
        report("distance of the centres", *row.center_distance_m, length);
      } else if (std::abs(*row.scores->b_iou - b_iou) > kRatioRounding) {
        report("b_iou", *row.scores->b_iou, b_iou);
      } else if (*row.scores->accuracy > length + kRounding_m) {
        report("accuracy", *row.scores->accuracy, length);
      } else if (*row.scores->completeness > length + kRounding_m) {
        report("completeness", *row.scores->completeness, length);
      }
    }
    add_(
        "everything moved inside every gate: P = R = 1, b_iou as that of moved boxes, surface "
        "distances at most the way",
        fault, fmt::format("by {:.3g} m", length));
  }

  /// Below every gate, and such that nobody comes closer to another object of its class.
  double smallestGate() const {
    double gate = INFINITY;
    for (const double tau : config_.thresholds_m) gate = std::min(gate, tau);
    const std::vector<ScoredObject>& truths = evaluator_.truths();
    for (std::size_t i = 0; i < truths.size(); ++i) {
      for (const double kappa : config_.kappas) {
        gate = std::min(gate, kappa * truths[i].detection.half_diagonal);
      }
      for (const DetectionObject& other : ignored_) {
        const double distance = (truths[i].detection.center - other.center).norm();
        gate = std::min({gate, distance > 0 ? distance : gate, other.half_diagonal});
      }
      for (std::size_t k = 0; k < i; ++k) {
        const double distance = (truths[i].detection.center - truths[k].detection.center).norm();
        if (truths[i].detection.label == truths[k].detection.label && distance > 0) {
          gate = std::min(gate, distance);
        }
      }
    }
    return gate;
  }

  void checkAtTheGate() {
    for (const double tau : config_.thresholds_m) {
      const DamagedPrediction inside = lifted(0.999 * tau);
      const MethodEvaluation scored = evaluator_.evaluate(inside.prediction);
      // What stood for ignored ground truth does so no more from afar, and then it counts.
      std::string fault;
      if (ignored_.empty()) fault = wrongRows(scored, "precision", "", 1.0, tau);
      if (ignored_.empty() && fault.empty()) fault = wrongRows(scored, "recall", "", 1.0, tau);
      if (fault.empty()) fault = countFault(scored, inside);
      const DamagedPrediction outside = lifted(1.001 * tau);
      if (fault.empty()) fault = countFault(evaluator_.evaluate(outside.prediction), outside);
      add_(fmt::format("everything 0.999 tau too high: P = R = 1 at tau = {} m; 1.001 tau: only "
                       "what comes near another object",
                       tau),
           fault, "");
    }
  }

  DamagedPrediction lifted(double height) const {
    return changed(perfect_, {Eigen::Matrix3d::Identity(), Eigen::Vector3d(0, 0, height)});
  }

  void checkMovedFar() {
    double lift_m = 100;
    for (const double tau : config_.thresholds_m) lift_m = std::max(lift_m, 2 * tau);
    for (const ScoredObject& object : evaluator_.truths()) {
      for (const double kappa : config_.kappas) {
        lift_m = std::max(lift_m, 2 * kappa * object.detection.half_diagonal);
      }
    }
    add_("everything far too high: R = 0",
         wrongRows(evaluator_.evaluate(lifted(lift_m).prediction), "recall", "", 0.0), "");
  }

  void checkInsideOut() {
    const MethodEvaluation scored = evaluator_.evaluate(turnedInsideOut(perfect_).prediction);
    std::string fault = wrongRows(scored, "precision", "", 1.0);
    if (fault.empty()) fault = wrongRows(scored, "recall", "", 1.0);
    std::size_t closed = 0;
    for (const ObjectRow& row : scored.objects) {
      if (!row.scores || !fault.empty()) continue;
      const ScoredObject& truth = scored.truths[*row.truth];
      const PairScores& scores = *row.scores;
      if (scores.accuracy != 0.0 || scores.completeness != 0.0) {
        fault = fmt::format("{}: accuracy = {}, completeness = {}", truth.name, *scores.accuracy,
                            *scores.completeness);
      } else if (scores.b_iou != 1.0 || scores.v_iou_surface != 1.0) {
        fault = fmt::format("{}: b_iou = {}, v_iou_surface = {}", truth.name, *scores.b_iou,
                            scores.v_iou_surface.value_or(-1));
      }
      if (!truth.watertight) continue;
      ++closed;
      if (scores.v_iou_solid && scores.v_iou_solid != 1.0) {
        fault = fmt::format("{}: v_iou_solid = {}", truth.name, *scores.v_iou_solid);
      }
    }
    add_("faces turned inside out: surface distances exactly 0, IoU of closed meshes 1", fault,
         fmt::format("{} closed pairs", closed));
  }

  void checkNotANumber() {
    std::size_t node = 0;
    const std::vector<ObjectNode>& nodes = perfect_.graph.objects;
    const auto scored = std::find_if(nodes.begin(), nodes.end(), [&](const ObjectNode& object) {
      const LabelSpace::Entry* entry = label_space_.find(object.label);
      return entry && entry->is_scored;
    });
    node = static_cast<std::size_t>(scored - nodes.begin());
    const std::string id = std::to_string(nodes[node].id);
    const Prediction damaged = withNan(perfect_, node);
    std::string fault = refusal(evaluator_, damaged, id);
    const std::vector<SubmissionFinding> findings = checkSubmission(label_space_, truth_, damaged);
    if (fault.empty() && findings.front().message.find(id) == std::string::npos) {
      fault = "not found before scoring";
    }
    add_("a coordinate that is not a number: refused with the id of its object", fault, "");
  }

  /// What is wrong with how the evaluator refuses it: the message must contain `text`.
  static std::string refusal(const Evaluator& evaluator, const Prediction& damaged,
                             const std::string& text) {
    try {
      evaluator.evaluate(damaged);
    } catch (const InputError& error) {
      const std::string message = error.what();
      return message.find(text) == std::string::npos ? "refused with: " + message : "";
    }
    return "scored";
  }

  struct Mistake {
    std::string what;
    CoordinateChange change;
    bool is_unit = false;  ///< sizes give it away, whatever the layout
  };

  void checkMistakes() {
    Eigen::Matrix3d y_up;
    y_up << 1, 0, 0, 0, 0, 1, 0, -1, 0;
    Eigen::Matrix3d exchanged;
    exchanged << 0, 1, 0, 1, 0, 0, 0, 0, 1;
    const Eigen::Matrix3d identity = Eigen::Matrix3d::Identity();
    const Eigen::Vector3d none = Eigen::Vector3d::Zero();
    const std::vector<Mistake> mistakes = {{"millimetres", {1000 * identity, none}, true},
                                           {"centimetres", {100 * identity, none}, true},
                                           {"kilometres", {0.001 * identity, none}, true},
                                           {"y up", {y_up, none}},
                                           {"x and y exchanged", {exchanged, none}},
                                           {"moved by 5 m", {identity, oblique(5)}}};
    // Only counts are looked at: voxels of objects a hundred times as large would take memory for
    // nothing.
    EvaluationConfig coarse = config_;
    coarse.samples = 10;
    coarse.voxel_pitch_m *= 1000;
    const Evaluator evaluator("mistakes", "", label_space_, truth_, coarse);
    for (const Mistake& mistake : mistakes) checkMistake(evaluator, mistake);
  }

  /// P and R as the centres say; and the mistake is seen before scoring, unless so much agrees with
  /// it that nobody could tell, or there are too few objects.
  void checkMistake(const Evaluator& evaluator, const Mistake& mistake) {
    const DamagedPrediction damaged = changed(perfect_, mistake.change);
    const MethodEvaluation scored =
        evaluator.evaluate(damaged.prediction, Evaluator::OtherUnits::kScoredAsIs);
    std::string fault = countFault(scored, damaged);
    bool found = false;
    std::string seen = "not seen before scoring: too few objects, or a layout that looks the same";
    for (const SubmissionFinding& finding :
         checkSubmission(label_space_, truth_, damaged.prediction)) {
      if (finding.topic != kPlacementTopic || finding.message.empty()) continue;
      seen = "seen before scoring: " + finding.message;
      found = true;
    }
    if (fault.empty() && !found && mistake.is_unit && evaluator_.truths().size() >= 3) {
      fault = "not seen before scoring";
    }
    const bool millimetres = mistake.change.linear(0, 0) == 1000;
    if (fault.empty() && millimetres)
      fault = refusal(evaluator, damaged.prediction, "1000 times as large");
    add_(mistake.what + ": P and R follow from the centres", fault, seen);
  }

  /// Rows of counts, P and R that are not what the definitions give for the damaged centres.
  std::string countFault(const MethodEvaluation& scored, const DamagedPrediction& damaged) const {
    const Counting counting = countingOf(scored);
    std::vector<DetectionObject> estimates;
    for (const DetectionObject& estimate : damaged.estimates) {
      if (counting.includes(estimate)) estimates.push_back(estimate);
    }
    for (const ScoreRow& row : scored.scores) {
      if (row.metric != "precision" && row.metric != "recall" && row.metric != "duplicates")
        continue;
      if (row.class_name == kAllMacro) continue;
      const bool exists = row.matching == kMatchingExists;
      const Threshold threshold = row.threshold_kind == name(Threshold::Kind::kTauM)
                                      ? Threshold::tau(*row.threshold)
                                      : Threshold::kappa(*row.threshold);
      const DetectionCounts counts =
          countsOf(row.class_name,
                   expectedCounts(estimates, counting.truths,
                                  exists ? Matching::kExists : Matching::kOneToOne, threshold));
      std::optional<double> expected =
          row.metric == "precision" ? precision(counts) : recall(counts);
      if (row.metric == "duplicates") {
        // Under exists there are none; under one_to_one whoever could match and was not let.
        const DetectionCounts could =
            countsOf(row.class_name,
                     expectedCounts(estimates, counting.truths, Matching::kExists, threshold));
        expected = static_cast<double>(could.matched_estimates - counts.matched_estimates);
      }
      if (row.value == expected) continue;
      return fmt::format("{} of {}, {} at {} {}: {}, expected {}", row.metric, row.class_name,
                         row.matching, row.threshold_kind, *row.threshold, text(row.value),
                         text(expected));
    }
    return "";
  }

  DetectionCounts countsOf(const std::string& class_name, const CountsByClass& counts) const {
    DetectionCounts total;
    for (const auto& [label, of_class] : counts) {
      if (class_name == kAllMicro || label_space_.nameOf(label) == class_name) total += of_class;
    }
    return total;
  }

  static std::string text(const std::optional<double>& value) {
    return value ? fmt::format("{}", *value) : "n/a";
  }

  const Evaluator& evaluator_;
  const EvaluationConfig& config_;
  const LabelSpace& label_space_;
  const GroundTruth& truth_;
  const Prediction& perfect_;
  const AddCheck& add_;
  std::vector<DetectionObject> ignored_;  ///< ground truth that is neither found nor missed
};

}  // namespace

void checkDamaged(const Evaluator& evaluator, const EvaluationConfig& config,
                  const LabelSpace& label_space, const GroundTruth& truth,
                  const Prediction& perfect, const AddCheck& add) {
  DamageChecks(evaluator, config, label_space, truth, perfect, add).run();
}

}  // namespace hydrabench

// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/evaluation/self_test.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <unistd.h>
#include <utility>

#include <fmt/format.h>

#include "core/graph/spark_dsg_json.h"
#include "core/io/atomic_file.h"
#include "core/types/error.h"
#include "eval/evaluation/damage_checks.h"
#include "eval/evaluation/order_check.h"
#include "eval/oracles/ground_truth_prediction.h"

namespace hydrabench {
namespace {

class SelfTest {
 public:
  SelfTest(std::string dataset_name, std::string seed, const LabelSpace& label_space,
           const EvaluationConfig& config, std::size_t shuffles,
           std::function<void(const SelfTestCheck&)> on_check)
      : dataset_name_(std::move(dataset_name)),
        seed_(std::move(seed)),
        label_space_(label_space),
        config_(config),
        shuffles_(shuffles),
        on_check_(std::move(on_check)) {}

  SelfTestReport run(const GroundTruth& truth) {
    const Evaluator evaluator(dataset_name_, seed_, label_space_, truth, config_);
    const Prediction perfect = groundTruthPrediction(label_space_, truth);
    report_.ground_truth = evaluator.evaluate(perfect);
    checkPerfect(report_.ground_truth, "ground truth against itself");
    checkGroundTruth(report_.ground_truth);
    checkSamplingFloor();
    checkOpenMeshes(truth);
    const EvaluationConfig quick = quickConfig();
    checkDamaged(Evaluator(dataset_name_, seed_, label_space_, truth, quick), quick, label_space_,
                 truth, perfect, add_);
    checkOrder(evaluator, perfect);
    checkShuffles(dataset_name_, seed_, label_space_, truth, config_, shuffles_, add_);
    checkFiles(evaluator, perfect);
    return std::move(report_);
  }

 private:
  void add(std::string claim, std::string fault, std::string seen = "") {
    SelfTestCheck check{std::move(claim), fault.empty(),
                        fault.empty() ? std::move(seen) : std::move(fault)};
    if (on_check_) on_check_(check);
    report_.checks.push_back(std::move(check));
  }

  /// Where only the values matter: no intervals, no shifted grids.
  EvaluationConfig quickConfig() const {
    EvaluationConfig config = config_;
    config.bootstrap_resamples = 0;
    config.jittered_origins = 0;
    return config;
  }

  void checkPerfect(const MethodEvaluation& evaluation, const std::string& what) {
    std::string fault;
    for (const char* metric : {"precision", "recall", "f1"}) {
      if (fault.empty()) fault = wrongRows(evaluation, metric, "", 1.0);
    }
    add(what + ": P = R = F1 = 1, both semantics, every threshold and class", fault,
        fmt::format("{} objects", evaluation.truths.size()));

    std::size_t values = 0;
    std::string ratio_fault;
    std::string distance_fault;
    for (const ObjectRow& row : evaluation.objects) {
      if (!row.scores) continue;
      for (const PairScoreColumn& column : pairScoreColumns()) {
        const std::optional<double>& value = (*row.scores).*column.value;
        if (column.direction == ScoreDirection::kReference || column.name == "chamfer_sq" || !value)
          continue;
        ++values;
        const bool ratio = column.direction == ScoreDirection::kHigherIsBetter;
        std::string& fault_text = ratio ? ratio_fault : distance_fault;
        if (*value != (ratio ? 1.0 : 0.0) && fault_text.empty()) {
          fault_text =
              fmt::format("{}: {} = {}", evaluation.truths[*row.truth].name, column.name, *value);
        }
      }
    }
    add(what + ": every IoU and F-score is 1", ratio_fault, fmt::format("{} values", values));
    add(what + ": every point-to-surface distance is exactly 0", distance_fault);
  }

  /// What scoring against itself cannot see, because both sides have the fault.
  void checkGroundTruth(const MethodEvaluation& evaluation) {
    std::string twice;
    std::string inverted;
    std::vector<double> diagonals;
    for (std::size_t i = 0; i < evaluation.truths.size(); ++i) {
      const ScoredObject& object = evaluation.truths[i];
      diagonals.push_back(2 * object.detection.half_diagonal);
      if (object.watertight && object.signed_volume_m3 < 0) inverted = object.name;
      for (std::size_t k = 0; k < i; ++k) {
        const ScoredObject& other = evaluation.truths[k];
        if (other.detection.label == object.detection.label &&
            boxIou(other.box, object.box) > 0.9) {
          twice = fmt::format("{} and {}", other.name, object.name);
        }
      }
    }
    add("no object is listed twice", twice.empty() ? "" : twice + " stand in one place");
    add("faces of closed meshes look outwards",
        inverted.empty() ? "" : inverted + " is inside out");
    std::nth_element(diagonals.begin(),
                     diagonals.begin() + static_cast<std::ptrdiff_t>(diagonals.size() / 2),
                     diagonals.end());
    const double diagonal = diagonals[diagonals.size() / 2];
    add("objects have the size of things, in metres",
        diagonal > 0.02 && diagonal < 20
            ? ""
            : fmt::format("median diagonal {:.3g} m, expected 0.02 to 20", diagonal),
        fmt::format("median diagonal {:.2f} m", diagonal));
  }

  void checkSamplingFloor() {
    if (config_.samples < 1000) return;  // too noisy to tell
    for (const ScoreRow& row : report_.ground_truth.scores) {
      if (row.metric != "chamfer_sq" || row.class_name != kAllMicro ||
          row.matching != kMatchingOneToOne)
        continue;
      const auto floor = std::find_if(
          report_.ground_truth.scores.begin(), report_.ground_truth.scores.end(),
          [&](const ScoreRow& other) {
            return other.metric == "chamfer_sq_floor" && other.class_name == row.class_name &&
                   other.matching == row.matching && other.threshold == row.threshold;
          });
      if (!row.value || floor == report_.ground_truth.scores.end() || !floor->value) continue;
      const double ratio = *row.value / *floor->value;
      add("sampled Chamfer of ground truth is its sampling floor",
          std::abs(ratio - 1) < 0.1 ? ""
                                    : fmt::format("ratio {:.3f}, expected 1 within 0.1", ratio),
          fmt::format("{:.3g} m^2 at {} samples", *row.value, config_.samples));
      return;
    }
  }

  /// Cuts away the upper half of every mesh: surfaces with a border, as partial maps have.
  void checkOpenMeshes(const GroundTruth& truth) {
    GroundTruth open;
    for (const GroundTruthObject& object : truth.objects) {
      const LabelSpace::Entry* entry = label_space_.find(object.label);
      if (!entry || !entry->is_scored) continue;
      Mesh half = *object.mesh;
      const double middle = bounds(half).center().z();
      std::erase_if(half.faces, [&](const Eigen::Vector3i& face) {
        return (half.vertices[static_cast<std::size_t>(face[0])].z() +
                half.vertices[static_cast<std::size_t>(face[1])].z() +
                half.vertices[static_cast<std::size_t>(face[2])].z()) /
                   3 >
               middle;
      });
      if (half.faces.empty()) continue;
      open.objects.push_back(object);
      open.objects.back().mesh = std::make_shared<const Mesh>(std::move(half));
    }
    const Evaluator evaluator(dataset_name_, seed_, label_space_, open, quickConfig());
    checkPerfect(evaluator.evaluate(groundTruthPrediction(label_space_, open)),
                 "meshes cut open, against themselves");
  }

  void checkOrder(const Evaluator& evaluator, const Prediction& perfect) {
    Prediction shuffled = perfect;
    shuffle(shuffled, config_.seed, 17);
    add("objects in another order under other ids: not a byte of scores.csv changes",
        scoresCsv(evaluator.evaluate(shuffled).scores) == scoresCsv(report_.ground_truth.scores)
            ? ""
            : "scores.csv differs");
  }

  void checkFiles(const Evaluator& evaluator, const Prediction& perfect) {
    struct Scratch {
      std::filesystem::path path = std::filesystem::temp_directory_path() /
                                   fmt::format("hydrabench_selftest_{}", ::getpid());
      ~Scratch() {
        std::error_code ignored;
        std::filesystem::remove_all(path, ignored);
      }
    } const scratch;
    writePrediction(scratch.path, perfect);
    const Prediction back = readPrediction(scratch.path);
    checkNanInFile(scratch.path / "scene_graph.json");
    add("written as scene_graph.json and read back: not a byte of scores.csv changes",
        scoresCsv(evaluator.evaluate(back).scores) == scoresCsv(report_.ground_truth.scores)
            ? ""
            : "scores.csv differs");
  }

  /// Python's json writes NaN without a word; reading must say whose it is.
  void checkNanInFile(const std::filesystem::path& file) {
    std::string text = readFile(file);
    const std::string points = "\"points\":[[";
    const std::size_t number = text.rfind(points) + points.size();
    text.replace(number, text.find_first_of(",]", number) - number, "NaN");
    writeFileAtomic(file, text);
    std::string fault = "read without a word";
    std::string seen;
    try {
      readPrediction(file);
    } catch (const InputError& error) {
      seen = std::string(error.what()).substr(file.string().size() + 2);
      fault = seen.find("node ") != std::string::npos && seen.find("points") != std::string::npos
                  ? ""
                  : seen;
    }
    add("NaN in a scene_graph.json: refused with the name of the node", fault, seen);
  }

  std::string dataset_name_;
  std::string seed_;
  const LabelSpace& label_space_;
  EvaluationConfig config_;
  std::size_t shuffles_;
  AddCheck add_ = [this](const std::string& claim, const std::string& fault,
                         const std::string& seen) { add(claim, fault, seen); };
  std::function<void(const SelfTestCheck&)> on_check_;
  SelfTestReport report_;
};

}  // namespace

bool SelfTestReport::passed() const {
  return std::all_of(checks.begin(), checks.end(),
                     [](const SelfTestCheck& check) { return check.passed; });
}

SelfTestReport runSelfTest(const std::string& dataset_name, const std::string& seed,
                           const LabelSpace& label_space, const GroundTruth& truth,
                           const EvaluationConfig& config, std::size_t shuffles,
                           const std::function<void(const SelfTestCheck&)>& on_check) {
  return SelfTest(dataset_name, seed, label_space, config, shuffles, on_check).run(truth);
}

}  // namespace hydrabench

// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/evaluation/order_check.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <mutex>
#include <unistd.h>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "core/graph/spark_dsg_json.h"
#include "core/io/atomic_file.h"
#include "core/parallel/parallel_for.h"
#include "core/types/random.h"
#include "eval/oracles/ground_truth_prediction.h"

namespace hydrabench {
namespace {

/// Streams of random numbers of this file, apart from each other.
enum Stream : std::uint64_t { kJitter = 100, kFirstShuffle = 1000 };

template <typename Item>
void permute(std::vector<Item>& items, Random& random) {
  for (std::size_t i = items.size(); i > 1; --i) {
    std::swap(items[i - 1], items[random.index(static_cast<std::uint32_t>(i))]);
  }
}

/// Distinct, ascending by no rule of the list.
std::vector<std::uint64_t> drawIds(std::size_t count, Random& random) {
  std::vector<std::uint64_t> ids;
  for (std::size_t i = 0; i < count; ++i) ids.push_back(1000 * i + random.index(1000));
  permute(ids, random);
  return ids;
}

void shuffle(std::vector<ObjectNode>& nodes, Random& random) {
  permute(nodes, random);
  const std::vector<std::uint64_t> ids = drawIds(nodes.size(), random);
  for (std::size_t i = 0; i < nodes.size(); ++i) nodes[i].id = objectNodeId(ids[i]);
}

void shuffle(std::vector<GroundTruthObject>& objects, Random& random) {
  permute(objects, random);
  const std::vector<std::uint64_t> ids = drawIds(objects.size(), random);
  for (std::size_t i = 0; i < objects.size(); ++i) objects[i].id = ids[i];
}

/// Scored objects as boxes in the world.
GroundTruth boxed(const LabelSpace& label_space, const GroundTruth& truth) {
  GroundTruth result;
  for (const GroundTruthObject& object : truth.objects) {
    const LabelSpace::Entry* entry = label_space.find(object.label);
    if (!entry || !entry->is_scored) continue;
    const Aabb box = objectBox(transformed(object.T_world_object, *object.mesh));
    result.objects.push_back(object);
    result.objects.back().T_world_object = Transform::Identity();
    result.objects.back().mesh = std::make_shared<const Mesh>(boxMesh(box));
  }
  return result;
}

ObjectNode moved(ObjectNode node, const Eigen::Vector3d& by) {
  for (Eigen::Vector3d& vertex : node.mesh.vertices) vertex += by;
  node.box.translate(by);
  return node;
}

/// Where order could matter. Distances are all different, except those of exact copies: between
/// equal distances of unequal objects ids decide, by definition.
Prediction crowded(const LabelSpace& label_space, const GroundTruth& truth,
                   const EvaluationConfig& config) {
  double reach = 1;
  for (const double tau : config.thresholds_m) reach = std::min(reach, tau);
  Random random(config.seed, kJitter);
  const auto jitter = [&](double length) {
    return Eigen::Vector3d(random.uniform(-length, length), random.uniform(-length, length),
                           random.uniform(-length, length));
  };
  const Prediction perfect = groundTruthPrediction(label_space, truth);
  Prediction result = perfect;
  result.graph.objects.clear();
  for (std::size_t i = 0; i < perfect.graph.objects.size(); ++i) {
    if (i % 3 == 2) continue;
    const ObjectNode node = moved(perfect.graph.objects[i], jitter(0.2 * reach));
    result.graph.objects.push_back(node);
    if (i % 2 != 0) continue;
    result.graph.objects.push_back(node);
    result.graph.objects.push_back(moved(node, jitter(reach)));
  }
  for (std::size_t i = 0; i < result.graph.objects.size(); ++i) {
    result.graph.objects[i].id = objectNodeId(i);
  }
  return result;
}

/// Boxes by their corners, prepared once: what a model holds depends on mesh and role alone.
class BoxModels {
 public:
  explicit BoxModels(const ObjectModel::Config& config) : config_(config) {}

  std::shared_ptr<const ObjectModel> get(Mesh mesh, ObjectModel::Role role) {
    std::pair<ObjectModel::Role, std::vector<double>> key(role, {});
    for (const Eigen::Vector3d& vertex : mesh.vertices) {
      key.second.insert(key.second.end(), vertex.begin(), vertex.end());
    }
    {
      const std::lock_guard lock(mutex_);
      if (const auto known = models_.find(key); known != models_.end()) return known->second;
    }
    auto model = std::make_shared<const ObjectModel>(std::move(mesh), role, config_);
    const std::lock_guard lock(mutex_);
    return models_.emplace(std::move(key), std::move(model)).first->second;
  }

 private:
  ObjectModel::Config config_;
  std::mutex mutex_;
  std::map<std::pair<ObjectModel::Role, std::vector<double>>, std::shared_ptr<const ObjectModel>>
      models_;
};

EvaluationConfig lightConfig(EvaluationConfig config) {
  config.samples = 50;
  config.jittered_origins = 0;
  config.bootstrap_resamples = 20;
  return config;
}

/// The first line that differs.
std::string difference(const std::string& expected, const std::string& found) {
  const auto [at, there] =
      std::mismatch(expected.begin(), expected.end(), found.begin(), found.end());
  const auto line_of = [](const std::string& text, std::size_t position) {
    const std::size_t begin = position == 0 ? 0 : text.rfind('\n', position - 1) + 1;
    return text.substr(begin, text.find('\n', position) - begin);
  };
  return fmt::format("'{}' for '{}'",
                     line_of(found, static_cast<std::size_t>(there - found.begin())),
                     line_of(expected, static_cast<std::size_t>(at - expected.begin())));
}

}  // namespace

void shuffle(Prediction& prediction, std::uint64_t seed, std::uint64_t stream) {
  Random random(seed, stream);
  shuffle(prediction.graph.objects, random);
}

void checkShuffles(const std::string& dataset_name, const std::string& seed,
                   const LabelSpace& label_space, const GroundTruth& truth,
                   const EvaluationConfig& config, std::size_t shuffles, const AddCheck& add) {
  const EvaluationConfig light = lightConfig(config);
  const GroundTruth boxes = boxed(label_space, truth);
  const Prediction prediction = crowded(label_space, boxes, config);
  const auto scores_of = [&](const GroundTruth& ground_truth, const Prediction& estimate,
                             const Evaluator::ModelSource& models) {
    const Evaluator evaluator(dataset_name, seed, label_space, ground_truth, light, models);
    return scoresCsv(evaluator.evaluate(estimate).scores);
  };
  const std::string expected = scores_of(boxes, prediction, {});
  BoxModels models(light.modelConfig());
  const auto prepared = [&models](Mesh mesh, ObjectModel::Role role) {
    return models.get(std::move(mesh), role);
  };
  // Never committed: files in it are not flushed to disk, and it goes with this function.
  const AtomicFolder scratch(std::filesystem::temp_directory_path() /
                             fmt::format("hydrabench_shuffles_{}", ::getpid()));
  std::vector<std::string> faults(shuffles);
  parallelFor(shuffles, [&](std::size_t i) {
    Random random(config.seed, kFirstShuffle + i);
    GroundTruth other_truth = boxes;
    shuffle(other_truth.objects, random);
    Prediction other = prediction;
    shuffle(other.graph.objects, random);
    const std::filesystem::path file = scratch.temporary() / fmt::format("{}.json", i);
    writeSparkDsg(file, other.graph);
    other.graph = readSparkDsg(file);
    std::filesystem::remove(file);
    const std::string scores = scores_of(other_truth, other, prepared);
    if (scores != expected) faults[i] = difference(expected, scores);
  });
  const auto wrong = std::find_if(faults.begin(), faults.end(),
                                  [](const std::string& fault) { return !fault.empty(); });
  const auto count = static_cast<std::size_t>(std::count_if(
      faults.begin(), faults.end(), [](const auto& fault) { return !fault.empty(); }));
  add("order and ids of objects, in prediction, file and ground truth: not a byte of scores.csv "
      "changes",
      count == 0 ? "" : fmt::format("{} of {} shuffles differ: {}", count, shuffles, *wrong),
      fmt::format("{} shuffle{} of {} boxes, {} samples, {} resamples", shuffles,
                  shuffles == 1 ? "" : "s", prediction.graph.objects.size(), light.samples,
                  light.bootstrap_resamples));
}

}  // namespace hydrabench

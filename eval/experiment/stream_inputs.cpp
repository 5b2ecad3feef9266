// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/experiment/stream_inputs.h"

#include <algorithm>
#include <set>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "core/graph/candidate_io.h"
#include "core/graph/spark_dsg_json.h"
#include "core/types/error.h"
#include "eval/experiment/map_dataset.h"
#include "eval/experiment/result_worlds.h"

namespace hydrabench {
namespace fs = std::filesystem;
namespace {

bool estimatesShapes(const fs::path& prediction) {
  return fs::exists(prediction / kCandidatesFile);
}

/// How long a track may be out of view before a run takes it for ended and asks for its shape.
double requestAfter(const fs::path& prediction, const StreamSources& sources) {
  if (sources.request_after_s) return *sources.request_after_s;
  const fs::path file = prediction / "config.yaml";
  double seconds = -1;
  if (fs::exists(file)) {
    ConfigReader reader(ConfigDocument::fromFile(file));
    reader.section("tracker").field("temporal_window_s", seconds, Bounds{0, 1e6});
    reader.throwFaults();
  }
  if (seconds < 0) {
    throw InputError(
        fmt::format("{}: tracker.temporal_window_s: missing, expected the time from the last "
                    "observation to the request, or --request-after",
                    file.string()));
  }
  return seconds;
}

std::optional<LatencyModel> measuredOf(const fs::path& prediction) {
  if (!fs::exists(prediction / kTimingFile)) return std::nullopt;
  for (const TimingRow& row : readTimingCsv(prediction / kTimingFile)) {
    if (row.stage == "estimate") return measuredLatency(row);
  }
  return std::nullopt;
}

/// A world that was opened, of which several methods' requests are read.
class OpenWorld {
 public:
  OpenWorld(const std::string& name, OpenedDataset opened, std::size_t max_frames,
            const EvaluationConfig& config)
      : opened_(std::move(opened)) {
    const Dataset& dataset = *opened_.dataset;
    if (!dataset.hasGroundTruth()) {
      throw InputError(fmt::format("{}: this dataset has no ground truth to score against", name));
    }
    world_.dataset = name;
    world_.seed = dataset.seed();
    world_.counting = countingOf(dataset, config);
    const std::vector<StampedPose>& path = dataset.groundTruth().trajectory;
    const std::size_t frames = max_frames == 0 ? path.size() : std::min(max_frames, path.size());
    if (frames < 2) {
      throw InputError(fmt::format("{}: {} frames, expected at least two", name, frames));
    }
    world_.start_ns = path.front().stamp_ns;
    world_.end_ns = path[frames - 1].stamp_ns;
  }

  StreamWorld with(const fs::path& prediction, const StreamSources& sources) const {
    StreamWorld world = world_;
    world.method = readPredictionDescription(prediction).method;
    world.candidates = readCandidates(prediction);
    world.decision = readDecisionOf(prediction);
    world.request_after_s = requestAfter(prediction, sources);
    world.measured = measuredOf(prediction);
    return world;
  }

 private:
  OpenedDataset opened_;
  StreamWorld world_;  ///< without a method
};

/// How a result was scored, and how much of its datasets was mapped; the defaults without one.
struct Scoring {
  EvaluationConfig evaluation;
  std::size_t max_frames = 0;  ///< 0: all
};

Scoring scoringOf(const fs::path& result) {
  Scoring scoring;
  if (result.empty()) return scoring;
  ConfigReader reader(ConfigDocument::fromFile(result / "config.yaml"));
  auto experiment = reader.section("experiment");
  auto evaluation = experiment.section("evaluation");
  read(evaluation, scoring.evaluation);
  std::uint64_t frames = 0;
  experiment.field("max_frames", frames);
  reader.throwFaults();  // the other keys are not ours to judge
  scoring.max_frames = static_cast<std::size_t>(frames);
  return scoring;
}

EvaluationConfig withOverrides(const EvaluationConfig& config,
                               const std::vector<std::string>& overrides) {
  ConfigDocument document = ConfigDocument::fromString(toYaml(config), "evaluation");
  for (const std::string& assignment : overrides) {
    if (!assignment.starts_with("evaluation.")) {
      throw InputError(
          fmt::format("--set {}: expected a key that starts with 'evaluation.'", assignment));
    }
    document.set(assignment.substr(std::string("evaluation.").size()));
  }
  ConfigReader reader(document);
  EvaluationConfig changed;
  read(reader, changed);
  reader.finish();
  return changed;
}

/// What is asked for of a folder of predictions, and what else is there.
class Selection {
 public:
  explicit Selection(const StreamSources& sources) : sources_(sources) {}

  bool takes(const fs::path& prediction) {
    if (!estimatesShapes(prediction)) return false;
    const std::string method = readPredictionDescription(prediction).method;
    known_.insert(method);
    const auto& wanted = sources_.methods;
    return wanted.empty() || std::find(wanted.begin(), wanted.end(), method) != wanted.end();
  }

  void requireAll() const {
    for (const std::string& method : sources_.methods) {
      if (known_.contains(method)) continue;
      const std::vector<std::string> known(known_.begin(), known_.end());
      const std::string guess = didYouMean(method, known);
      throw InputError(
          fmt::format("--method {}: not among those that estimate shapes: {}{}", method,
                      known.empty() ? "none" : fmt::format("{}", fmt::join(known, ", ")),
                      guess.empty() ? "" : fmt::format("; did you mean '{}'?", guess)));
    }
  }

 private:
  const StreamSources& sources_;
  std::set<std::string> known_;
};

void requireDistinct(const std::vector<StreamWorld>& worlds) {
  std::set<std::string> seen;
  for (const StreamWorld& world : worlds) {
    const std::string name =
        fmt::format("{}, seed {}, method '{}'", world.dataset, world.seed, world.method);
    if (!seen.insert(name).second) {
      throw InputError(fmt::format("{}: given twice, expected each once", name));
    }
  }
}

}  // namespace

Counting countingOf(const Dataset& dataset, const EvaluationConfig& config) {
  Counting counting;
  counting.label_space = dataset.labelSpace();
  for (const GroundTruthObject& object : dataset.groundTruth().objects) {
    const LabelSpace::Entry* entry = counting.label_space.find(object.label);
    if (!entry || !entry->is_scored) continue;
    const bool counts = object.scored && object.visible_fraction >= config.min_visible_fraction;
    (counts ? counting.truths : counting.ignored)
        .push_back(detectionObject(object.id, object.label,
                                   transformed(object.T_world_object, *object.mesh)));
  }
  if (counting.truths.empty()) {
    throw InputError(
        fmt::format("dataset '{}': ground truth: no object that counts, expected at "
                    "least one",
                    dataset.name()));
  }
  return counting;
}

StreamInputs readStreamInputs(const StreamSources& sources,
                              const std::function<void(const std::string& world)>& on_world) {
  StreamInputs inputs;
  Selection selection(sources);
  bool is_first = true;
  for (const fs::path& path : sources.paths) {
    const bool is_result = fs::is_directory(path / "predictions");
    if (!is_result && !fs::exists(path)) {
      throw InputError(
          fmt::format("{}: no such folder, expected a result or a prediction", path.string()));
    }
    const Scoring scoring = scoringOf(is_result ? path : fs::path());
    const EvaluationConfig evaluation = withOverrides(scoring.evaluation, sources.overrides);
    if (!is_first && !(evaluation == inputs.evaluation)) {
      throw InputError(
          fmt::format("{}: evaluation: not that of {}, expected results that were "
                      "scored alike",
                      path.string(), sources.paths.front().string()));
    }
    is_first = false;
    inputs.evaluation = evaluation;
    if (!is_result) {
      if (!selection.takes(path)) {
        if (estimatesShapes(path)) continue;
        throw InputError(
            fmt::format("{}: no {} in there, expected the prediction of a method "
                        "that estimates shapes",
                        path.string(), kCandidatesFile));
      }
      if (sources.dataset.empty()) {
        throw InputError(fmt::format("{}: a prediction, expected --dataset with its ground truth",
                                     path.string()));
      }
      OpenedDataset opened = openDataset(sources.dataset);
      const std::string name = opened.dataset->name();
      on_world(name);
      inputs.worlds.push_back(
          OpenWorld(name, std::move(opened), scoring.max_frames, evaluation).with(path, sources));
      continue;
    }
    for (const ResultWorld& world : resultWorlds(path)) {
      std::vector<fs::path> taken;
      for (const fs::path& prediction : world.predictions) {
        if (selection.takes(prediction)) taken.push_back(prediction);
      }
      if (taken.empty()) continue;  // opening a world takes time
      on_world(world.dataset + ", seed " + world.seed);
      const OpenWorld open(world.dataset, world.open(), scoring.max_frames, evaluation);
      for (const fs::path& prediction : taken)
        inputs.worlds.push_back(open.with(prediction, sources));
    }
  }
  selection.requireAll();
  if (inputs.worlds.empty()) {
    throw InputError(
        fmt::format("{}: no method that estimates shapes, expected {} beside a "
                    "scene graph",
                    sources.paths.front().string(), kCandidatesFile));
  }
  requireDistinct(inputs.worlds);
  inputs.resolved_config = toYaml(inputs.evaluation);
  return inputs;
}

}  // namespace hydrabench

// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/experiment/job_runner.h"

#include <algorithm>
#include <exception>
#include <map>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "core/graph/spark_dsg_json.h"
#include "core/io/atomic_file.h"
#include "core/types/error.h"
#include "eval/datasets/open_dataset.h"
#include "eval/evaluation/evaluation_io.h"
#include "eval/experiment/content_hash.h"
#include "eval/experiment/map_dataset.h"
#include "eval/experiment/run_record.h"

namespace hydrabench {
namespace {

/// What a decision is made from, or for methods without one what was written.
Prediction predictionOf(const std::filesystem::path& run, const ScoreUnit& score,
                        const LabelSpace& label_space) {
  Prediction prediction;
  if (score.decision.empty()) {
    prediction = readPrediction(run);
  } else {
    ConfigReader reader(ConfigDocument::fromString(score.decision, "decision"));
    DecisionConfig decision;
    read(reader, decision);
    reader.finish();
    prediction = readCandidatePrediction(run);
    prediction.graph.label_space = label_space;
    redecide(prediction, decision);
  }
  prediction.method = score.method;
  return prediction;
}

/// Evaluators of one world, one for each way to score.
class Evaluators {
 public:
  Evaluators(const WorldSpec& world, const Dataset& dataset) : world_(world), dataset_(dataset) {}

  const Evaluator& at(const EvaluationConfig& config) {
    for (const auto& [known, evaluator] : evaluators_) {
      if (known == config) return *evaluator;
    }
    evaluators_.emplace_back(config, std::make_unique<const Evaluator>(
                                         world_.dataset, std::to_string(world_.seed),
                                         dataset_.labelSpace(), dataset_.groundTruth(), config));
    return *evaluators_.back().second;
  }

 private:
  const WorldSpec& world_;
  const Dataset& dataset_;
  std::vector<std::pair<EvaluationConfig, std::unique_ptr<const Evaluator>>> evaluators_;
};

}  // namespace

JobRunner::JobRunner(UnitStore store)
    : JobRunner(std::move(store), [](const std::string& config) {
        return readMethod(ConfigDocument::fromString(config, "method"));
      }) {}

JobRunner::JobRunner(UnitStore store, MethodReader read_method)
    : store_(std::move(store)), read_method_(std::move(read_method)) {}

void JobRunner::run(const Job& job, const JobEvents& events) {
  std::vector<RunUnit> runs = job.runs;
  // In one order everywhere, or two jobs might wait for each other.
  std::sort(runs.begin(), runs.end(),
            [](const RunUnit& a, const RunUnit& b) { return a.hash < b.hash; });
  std::vector<UnitStore::Lock> locks;
  for (const RunUnit& run : runs) locks.push_back(store_.lock(run.hash));
  std::erase_if(runs, [&](const RunUnit& run) { return store_.isDone(run.hash); });
  if (!runs.empty()) map(job.world, std::move(runs), events);
  locks.clear();

  std::vector<ScoreUnit> scores = job.scores;
  std::erase_if(scores, [&](const ScoreUnit& score) {
    return store_.isDone(score.hash) || !store_.isDone(score.run);
  });
  if (!scores.empty()) score(job.world, scores, events);
}

const Dataset& JobRunner::open(const WorldSpec& world) {
  if (!dataset_ || opened_ != world.config) {
    dataset_.reset();  // its memory, before the next one
    dataset_ = openDataset(ConfigDocument::fromString(world.config, world.dataset)).dataset;
    opened_ = world.config;
  }
  return *dataset_;
}

void JobRunner::map(const WorldSpec& world, std::vector<RunUnit> runs, const JobEvents& events) {
  const auto failAll = [&](const std::string& message) {
    for (const RunUnit& run : runs) fail({world, {run}, {}}, message, events);
  };
  try {
    const Dataset& dataset = open(world);
    const std::size_t frames = world.max_frames == 0
                                   ? dataset.numFrames()
                                   : std::min(world.max_frames, dataset.numFrames());
    std::vector<MethodConfig> methods;
    for (const RunUnit& run : runs) {
      methods.push_back(read_method_(run.mapping_config));
      methods.back().name = run.methods.front();
    }
    if (events.on_world) events.on_world(world, frames);
    const DatasetRun done = mapDataset(dataset, methods, frames, events.on_frame);
    for (std::size_t i = 0; i < runs.size(); ++i) {
      if (!done.methods[i].prediction) {
        fail({world, {runs[i]}, {}}, done.methods[i].failure, events);
        continue;
      }
      AtomicFolder folder(store_.runFolder(runs[i].hash));
      fillRunFolder(folder.temporary(), done.methods[i]);
      writeFileAtomic(folder.temporary() / kRunRecordFile,
                      runRecordJson({frames, done.frame_period_s}));
      folder.commit();
      store_.clearFailure(runs[i].hash);
    }
  } catch (const OutputError&) {
    throw;  // a full disk fails everything that follows, too
  } catch (const std::exception& error) {
    if (runs.size() == 1) return failAll(error.what());
    // One of them spoils it for all: each by itself.
    for (const RunUnit& run : runs) {
      if (!store_.isDone(run.hash)) map(world, {run}, events);
    }
  }
}

void JobRunner::score(const WorldSpec& world, const std::vector<ScoreUnit>& scores,
                      const JobEvents& events) {
  std::optional<Evaluators> evaluators;
  for (const ScoreUnit& score : scores) {
    try {
      const Dataset& dataset = open(world);
      if (!evaluators) evaluators.emplace(world, dataset);
      const Prediction prediction =
          predictionOf(store_.runFolder(score.run), score, dataset.labelSpace());
      MethodEvaluation evaluation;
      if (dataset.hasGroundTruth()) {
        evaluation = evaluators->at(score.evaluation).evaluate(prediction);
      }
      evaluation.dataset = world.dataset;
      evaluation.seed = std::to_string(world.seed);
      evaluation.method = score.method;
      evaluation.notes = prediction.notes;
      writeFileAtomic(store_.scoreFile(score.hash), evaluationJson(evaluation));
      store_.clearFailure(score.hash);
    } catch (const OutputError&) {
      throw;
    } catch (const std::exception& error) {
      fail({world, {}, {score}}, error.what(), events);
    }
  }
}

void JobRunner::fail(const Job& unit, const std::string& message, const JobEvents& events) const {
  const std::string& hash = unit.runs.empty() ? unit.scores.front().hash : unit.runs.front().hash;
  store_.recordFailure(hash, message.empty() ? "unknown error" : message, unit);
  if (events.on_failure) events.on_failure(unit.label(), message);
}

}  // namespace hydrabench

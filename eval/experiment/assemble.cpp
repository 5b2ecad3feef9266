// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/experiment/assemble.h"

#include <algorithm>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "core/graph/spark_dsg_json.h"
#include "core/io/atomic_file.h"
#include "core/parallel/parallel_for.h"
#include "eval/evaluation/evaluation_io.h"
#include "eval/evaluation/method_scores.h"
#include "eval/experiment/indented.h"
#include "eval/experiment/map_dataset.h"
#include "eval/experiment/run_record.h"
#include "eval/report/comparison_table.h"

namespace hydrabench {
namespace fs = std::filesystem;
namespace {

/// What the store has of one method on one world.
struct Gathered {
  bool mapped = false;
  std::vector<TimingRow> timing;  ///< none where instructions were counted: it takes long then
  std::vector<FrameTimes> frame_times;
  double frame_period_s = 0;
  std::optional<MethodEvaluation> evaluation;
  std::string failure;  ///< empty: none
  fs::path failed_job;
};

std::string seedOf(const Plan::World& world) { return std::to_string(world.spec.seed); }

std::vector<TimingRow> timingOf(const fs::path& run, const std::string& dataset,
                                const std::string& method) {
  std::vector<TimingRow> rows = readTimingCsv(run / kTimingFile);
  for (TimingRow& row : rows) {
    row.dataset = dataset;
    row.method = method;
  }
  return rows;
}

std::vector<FrameTimes> frameTimesOf(const fs::path& run, const std::string& dataset,
                                     const std::string& method) {
  std::vector<FrameTimes> times = readFrameTimesCsv(run / kFrameTimesFile);
  for (FrameTimes& of_run : times) {
    of_run.dataset = dataset;
    of_run.method = method;
  }
  return times;
}

/// Whether the decision is the one that was made at the end of mapping.
bool isDecidedAsMapped(const MethodConfig& method) {
  return !method.decision ||
         readMethod(ConfigDocument::fromString(method.mapping_config)).decision == method.decision;
}

Gathered gather(const ExperimentConfig& experiment, const MethodConfig& method,
                const std::string& dataset, const Plan::Cell& cell, const UnitStore& store,
                Scores scores) {
  Gathered gathered;
  const auto fail = [&](const std::string& hash) {
    gathered.failure = store.failure(hash).value_or("not done");
    if (fs::exists(store.failureFile(hash))) gathered.failed_job = store.failureFile(hash);
    return gathered;
  };
  if (!store.isDone(cell.run)) return fail(cell.run);
  const fs::path run = store.runFolder(cell.run);
  gathered.mapped = true;
  gathered.frame_times = frameTimesOf(run, dataset, method.name);
  const bool counted = !gathered.frame_times.empty() && gathered.frame_times.front().isCounted();
  if (!counted) gathered.timing = timingOf(run, dataset, method.name);
  gathered.frame_period_s = readRunRecord(run / kRunRecordFile).frame_period_s;
  if (!store.isDone(cell.score)) return fail(cell.score);
  if (scores == Scores::kLeftOut) return gathered;
  MethodEvaluation evaluation = readEvaluation(store.scoreFile(cell.score));
  evaluation.dataset = dataset;
  evaluation.method = method.name;
  if (evaluation.isScored()) rescore(experiment.evaluation, evaluation);
  gathered.evaluation = std::move(evaluation);
  return gathered;
}

class Assembly {
 public:
  Assembly(const ExperimentConfig& experiment, const Plan& plan, const UnitStore& store,
           Scores scores)
      : experiment_(experiment), plan_(plan), store_(store), scores_(scores) {
    outcome_.result.evaluation = experiment.evaluation;
    std::string& config = outcome_.result.config;
    config = "experiment:\n" + indented(experiment.resolved_config, 2) + "methods:\n";
    for (const MethodConfig& method : experiment.methods) {
      config += "  " + method.name + ":\n" + indented(method.resolved_config, 4);
    }
    config += "datasets:\n";
  }

  void add(const Plan::PlannedDataset& dataset) {
    for (const Plan::PlannedWorld& world : dataset.worlds) {
      const WorldSpec& spec = plan_.worlds[world.world].spec;
      outcome_.result.config += fmt::format("  {}_{}:\n", dataset.name, spec.seed);
      outcome_.result.config += indented(spec.config, 4);
    }
    const std::size_t num_methods = experiment_.methods.size();
    std::vector<Gathered> all(dataset.worlds.size() * num_methods);
    parallelFor(all.size(), [&](std::size_t i) {
      const std::size_t m = i % num_methods;
      all[i] = gather(experiment_, experiment_.methods[m], dataset.name,
                      dataset.worlds[i / num_methods].cells[m], store_, scores_);
    });
    const std::size_t first = outcome_.result.evaluations.size();
    bool scored = false;
    for (std::size_t i = 0; i < all.size(); ++i) {
      const Plan::World& world = plan_.worlds[dataset.worlds[i / num_methods].world];
      scored |= add(dataset.name, seedOf(world), experiment_.methods[i % num_methods].name,
                    std::move(all[i]));
    }
    if (scored) pool(dataset, first);
  }

  ExperimentOutcome take() {
    outcome_.result.differences =
        pairedDifferences(outcome_.result.evaluations, experiment_.evaluation);
    return std::move(outcome_);
  }

 private:
  /// Returns whether there is a score.
  bool add(const std::string& dataset, const std::string& seed, const std::string& method,
           Gathered gathered) {
    Result& result = outcome_.result;
    if (gathered.mapped) {
      ++outcome_.predictions;
      result.timing.insert(result.timing.end(), gathered.timing.begin(), gathered.timing.end());
      std::move(gathered.frame_times.begin(), gathered.frame_times.end(),
                std::back_inserter(result.frame_times));
      outcome_.frame_period_s[dataset] = gathered.frame_period_s;
    }
    if (!gathered.failure.empty()) {
      outcome_.failures.push_back({fmt::format("{}, seed {}, {}", dataset, seed, method),
                                   gathered.failure, gathered.failed_job});
    }
    if (!gathered.evaluation) return false;
    for (const std::string& note : gathered.evaluation->notes) addNote(method, note);
    if (!gathered.evaluation->isScored()) return false;
    result.evaluations.push_back(std::move(*gathered.evaluation));
    return true;
  }

  /// The worlds of one dataset together; says so where some are missing.
  /// @param first  where the evaluations of this dataset begin
  void pool(const Plan::PlannedDataset& dataset, std::size_t first) {
    const std::vector<MethodEvaluation>& evaluations = outcome_.result.evaluations;
    const std::size_t planned = dataset.worlds.size();
    std::vector<std::vector<const MethodEvaluation*>> worlds(experiment_.methods.size());
    for (std::size_t m = 0; m < worlds.size(); ++m) {
      const std::string& method = experiment_.methods[m].name;
      for (std::size_t i = first; i < evaluations.size(); ++i) {
        if (evaluations[i].method == method) worlds[m].push_back(&evaluations[i]);
      }
      if (worlds[m].size() == planned) continue;
      addNote(method, fmt::format("{} of {} worlds of {} failed and are not in the table",
                                  planned - worlds[m].size(), planned, dataset.name));
    }
    if (planned < 2) return;
    std::vector<MethodEvaluation> pools(worlds.size());
    parallelFor(worlds.size(), [&](std::size_t m) {
      if (!worlds[m].empty()) pools[m] = pooled(worlds[m], experiment_.evaluation);
    });
    for (MethodEvaluation& pool : pools) {
      if (pool.isScored()) outcome_.result.evaluations.push_back(std::move(pool));
    }
  }

  void addNote(const std::string& method, const std::string& note) {
    std::vector<std::string>& notes = outcome_.result.notes;
    const std::string line = methodLabel(method) + ": " + note;
    if (std::find(notes.begin(), notes.end(), line) == notes.end()) notes.push_back(line);
  }

  const ExperimentConfig& experiment_;
  const Plan& plan_;
  const UnitStore& store_;
  Scores scores_;
  ExperimentOutcome outcome_;
};

/// A file of the store under another name; what is in the store never changes.
void linkFile(const fs::path& from, const fs::path& to) {
  fs::create_directories(to.parent_path());
  std::error_code error;
  fs::create_hard_link(from, to, error);
  if (error) fs::copy_file(from, to);
}

void linkFiles(const fs::path& from, const fs::path& to) {
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(from)) {
    if (!entry.is_regular_file()) continue;
    const fs::path name = entry.path().lexically_relative(from);
    if (name == kRunRecordFile || fs::exists(to / name)) continue;
    linkFile(entry.path(), to / name);
  }
}

}  // namespace

ExperimentOutcome assembled(const ExperimentConfig& experiment,
                            const Plan::PlannedExperiment& planned, const Plan& plan,
                            const UnitStore& store, Scores scores) {
  Assembly assembly(experiment, plan, store, scores);
  for (const Plan::PlannedDataset& dataset : planned) assembly.add(dataset);
  return assembly.take();
}

void linkPredictions(const ExperimentConfig& experiment, const Plan::PlannedExperiment& planned,
                     const Plan& plan, const UnitStore& store, const fs::path& folder) {
  for (const Plan::PlannedDataset& dataset : planned) {
    for (const Plan::PlannedWorld& world : dataset.worlds) {
      for (std::size_t m = 0; m < experiment.methods.size(); ++m) {
        const fs::path run = store.runFolder(world.cells[m].run);
        if (!fs::exists(run)) continue;
        const MethodConfig& method = experiment.methods[m];
        const fs::path out =
            folder / "predictions" / dataset.name / seedOf(plan.worlds[world.world]) / method.name;
        // What differs between methods that share a run is written, the rest linked.
        if (isDecidedAsMapped(method)) {
          PredictionDescription description = readPredictionDescription(run);
          description.method = method.name;
          writePredictionDescription(out, description);
        } else {
          Prediction prediction = readPrediction(run);
          prediction.method = method.name;
          redecide(prediction, *method.decision);
          fillPredictionFolder(out, prediction);
        }
        writeFileAtomic(out / kTimingFile, timingCsv(timingOf(run, dataset.name, method.name)));
        writeFileAtomic(out / kFrameTimesFile,
                        frameTimesCsv(frameTimesOf(run, dataset.name, method.name)));
        writeFileAtomic(out / "config.yaml", method.resolved_config);
        linkFiles(run, out);
      }
    }
  }
}

}  // namespace hydrabench

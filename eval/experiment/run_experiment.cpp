// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/experiment/run_experiment.h"

#include <algorithm>
#include <exception>
#include <set>
#include <utility>

#include <fmt/format.h>

#include "core/config/plain_name.h"
#include "core/types/error.h"
#include "eval/evaluation/method_scores.h"
#include "eval/experiment/indented.h"
#include "eval/experiment/map_dataset.h"
#include "eval/report/comparison_table.h"

namespace hydrabench {
namespace {

/// Collects what the worlds leave behind.
class ExperimentRun {
 public:
  ExperimentRun(const ExperimentConfig& experiment, std::filesystem::path folder,
                const ExperimentEvents& events)
      : experiment_(experiment), folder_(std::move(folder)), events_(events) {
    outcome_.result.evaluation = experiment.evaluation;
    std::string& config = outcome_.result.config;
    config = "experiment:\n" + indented(experiment.resolved_config, 2) + "methods:\n";
    for (const MethodConfig& method : experiment.methods) {
      config += "  " + method.name + ":\n" + indented(method.resolved_config, 4);
    }
    config += "datasets:\n";
  }

  void run(const ExperimentConfig::DatasetEntry& entry) {
    name_ = entry.name;
    const std::size_t first = outcome_.result.evaluations.size();
    for (std::size_t i = 0; i < entry.numWorlds(); ++i) {
      try {
        mapWorld(entry, i);
      } catch (const std::exception& error) {
        if (nothingHappened()) throw;  // most likely a wrong path: better said at once
        const std::string seed =
            entry.seeds.empty() ? "" : fmt::format(", seed {}", entry.seeds[i]);
        fail(fmt::format("{}{}: {}", name_.empty() ? entry.config.string() : name_, seed,
                         error.what()));
      }
    }
    if (scored_) pool(entry.numWorlds(), first);
  }

  ExperimentOutcome take() { return std::move(outcome_); }

 private:
  void mapWorld(const ExperimentConfig::DatasetEntry& entry, std::size_t index) {
    const OpenedDataset opened = entry.open(index);
    const Dataset& dataset = *opened.dataset;
    if (name_.empty()) name_ = dataset.name();
    if (!isPlainName(name_)) {
      throw InputError(fmt::format("{}: dataset name '{}', {}", entry.config.string(), name_,
                                   kPlainNameExpected));
    }
    if (index == 0 && !names_.insert(name_).second) {
      throw InputError(fmt::format(
          "{}: another dataset is called '{}', expected different names (give one a 'name')",
          entry.config.string(), name_));
    }
    const std::string seed = std::to_string(dataset.seed());
    outcome_.result.config +=
        fmt::format("  {}_{}:\n", name_, seed) + indented(opened.resolved_config, 4);
    const std::size_t frames = experiment_.max_frames == 0
                                   ? dataset.numFrames()
                                   : std::min(experiment_.max_frames, dataset.numFrames());
    if (events_.on_world) events_.on_world(name_, seed, frames);
    DatasetRun runs = mapDataset(dataset, experiment_.methods, frames, events_.on_frame);
    outcome_.frame_period_s[name_] = runs.frame_period_s;
    for (MethodRun& run : runs.methods) {
      for (TimingRow& row : run.timing) row.dataset = name_;
      if (run.prediction) {
        keep(run, seed);
      } else {
        fail(fmt::format("{}, seed {}, {}: {}", name_, seed, run.method, run.failure));
      }
    }
    scored_ = dataset.hasGroundTruth();
    if (scored_) score(dataset, seed, runs);
  }

  void keep(const MethodRun& run, const std::string& seed) {
    fillRunFolder(folder_ / "predictions" / name_ / seed / run.method, run);
    ++outcome_.predictions;
    outcome_.result.timing.insert(outcome_.result.timing.end(), run.timing.begin(),
                                  run.timing.end());
    for (const std::string& note : run.prediction->notes) addNote(run.method, note);
  }

  void score(const Dataset& dataset, const std::string& seed, const DatasetRun& runs) {
    label_space_ = dataset.labelSpace();
    const Evaluator evaluator(name_, seed, label_space_, dataset.groundTruth(),
                              experiment_.evaluation);
    for (const MethodRun& run : runs.methods) {
      if (!run.prediction) continue;
      try {
        outcome_.result.evaluations.push_back(evaluator.evaluate(*run.prediction));
      } catch (const std::exception& error) {
        fail(fmt::format("{}, seed {}, {}: {}", name_, seed, run.method, error.what()));
      }
    }
  }

  /// The worlds of one dataset together; says so where some are missing.
  /// @param first  where the evaluations of this dataset begin
  void pool(std::size_t planned, std::size_t first) {
    const std::vector<MethodEvaluation>& evaluations = outcome_.result.evaluations;
    std::vector<MethodEvaluation> pools;
    for (const MethodConfig& method : experiment_.methods) {
      std::vector<const MethodEvaluation*> worlds;
      for (std::size_t i = first; i < evaluations.size(); ++i) {
        if (evaluations[i].method == method.name) worlds.push_back(&evaluations[i]);
      }
      if (worlds.size() < planned) {
        addNote(method.name, fmt::format("{} of {} worlds of {} failed and are not in the table",
                                         planned - worlds.size(), planned, name_));
      }
      if (planned < 2 || worlds.empty()) continue;
      pools.push_back(pooled(worlds, label_space_, experiment_.evaluation));
    }
    std::move(pools.begin(), pools.end(), std::back_inserter(outcome_.result.evaluations));
  }

  void fail(const std::string& message) {
    outcome_.failures.push_back(message);
    if (events_.on_failure) events_.on_failure(message);
  }

  void addNote(const std::string& method, const std::string& note) {
    std::vector<std::string>& notes = outcome_.result.notes;
    const std::string line = methodLabel(method) + ": " + note;
    if (std::find(notes.begin(), notes.end(), line) == notes.end()) notes.push_back(line);
  }

  bool nothingHappened() const { return outcome_.predictions == 0 && outcome_.failures.empty(); }

  const ExperimentConfig& experiment_;
  std::filesystem::path folder_;
  const ExperimentEvents& events_;
  ExperimentOutcome outcome_;
  std::set<std::string> names_;  ///< of datasets so far
  // Of the dataset at hand:
  std::string name_;
  bool scored_ = false;
  LabelSpace label_space_;
};

}  // namespace

ExperimentOutcome runExperiment(const ExperimentConfig& experiment,
                                const std::filesystem::path& folder,
                                const ExperimentEvents& events) {
  ExperimentRun run(experiment, folder, events);
  for (const ExperimentConfig::DatasetEntry& entry : experiment.datasets) run.run(entry);
  return run.take();
}

}  // namespace hydrabench

// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/experiment/run_experiment.h"

#include <algorithm>
#include <exception>
#include <set>
#include <utility>

#include <fmt/format.h>

#include "core/types/error.h"
#include "eval/evaluation/method_scores.h"
#include "eval/experiment/map_dataset.h"
#include "eval/report/comparison_table.h"

namespace hydrabench {
namespace {

std::string indented(const std::string& yaml) {
  std::string text = "    ";
  for (std::size_t i = 0; i < yaml.size(); ++i) {
    text += yaml[i];
    if (yaml[i] == '\n' && i + 1 < yaml.size()) text += "    ";
  }
  if (!text.ends_with('\n')) text += '\n';
  return text;
}

/// Collects what the worlds leave behind.
class ExperimentRun {
 public:
  ExperimentRun(const ExperimentConfig& experiment, std::filesystem::path folder,
                const ExperimentEvents& events)
      : experiment_(experiment), folder_(std::move(folder)), events_(events) {
    outcome_.result.config = "experiment:\n" + indented(experiment.resolved_config);
    outcome_.result.config += "methods:\n";
    for (const MethodConfig& method : experiment.methods) {
      outcome_.result.config += "  " + method.name + ":\n" + indented(method.resolved_config);
    }
    outcome_.result.config += "datasets:\n";
  }

  void mapWorld(const ExperimentConfig::World& world) {
    const OpenedDataset opened = experiment_.open(world);
    const Dataset& dataset = *opened.dataset;
    const std::string seed = std::to_string(dataset.seed());
    if (!worlds_.insert(dataset.name() + " " + seed).second) {
      throw InputError(
          fmt::format("dataset '{}', seed {} occurs twice, expected different names or seeds",
                      dataset.name(), seed));
    }
    outcome_.result.config +=
        fmt::format("  {}_{}:\n", dataset.name(), seed) + indented(opened.resolved_config);
    const std::size_t frames = experiment_.max_frames == 0
                                   ? dataset.numFrames()
                                   : std::min(experiment_.max_frames, dataset.numFrames());
    if (events_.on_world) events_.on_world(dataset, frames);
    DatasetRun runs = mapDataset(dataset, experiment_.methods, frames, events_.on_frame);
    outcome_.frame_period_s[dataset.name()] = runs.frame_period_s;
    for (const MethodRun& run : runs.methods) {
      if (!run.prediction) {
        fail(fmt::format("{}, seed {}, {}: {}", dataset.name(), seed, run.method, run.failure));
        continue;
      }
      fillRunFolder(folder_ / "predictions" / dataset.name() / seed / run.method, run);
      outcome_.result.timing.insert(outcome_.result.timing.end(), run.timing.begin(),
                                    run.timing.end());
      for (const std::string& note : run.prediction->notes) addNote(run.method, note);
    }
    if (dataset.hasGroundTruth()) score(dataset, seed, runs);
  }

  void poolSeeds() {
    std::vector<MethodEvaluation> pools;
    for (const auto& [dataset, label_space] : label_spaces_) {
      for (const MethodConfig& method : experiment_.methods) {
        std::vector<const MethodEvaluation*> worlds;
        for (const MethodEvaluation& evaluation : outcome_.result.evaluations) {
          if (evaluation.dataset == dataset && evaluation.method == method.name) {
            worlds.push_back(&evaluation);
          }
        }
        if (worlds.empty() || seeds_[dataset] < 2) continue;
        pools.push_back(pooled(worlds, label_space, experiment_.evaluation));
        if (worlds.size() < seeds_[dataset]) {
          addNote(method.name, fmt::format("{} of {} seeds only; the others failed", worlds.size(),
                                           seeds_[dataset]));
        }
      }
    }
    std::move(pools.begin(), pools.end(), std::back_inserter(outcome_.result.evaluations));
  }

  void fail(const std::string& message) {
    outcome_.failures.push_back(message);
    if (events_.on_message) events_.on_message("failed: " + message);
  }

  bool nothingDone() const { return outcome_.result.timing.empty(); }
  ExperimentOutcome take() { return std::move(outcome_); }

 private:
  void score(const Dataset& dataset, const std::string& seed, const DatasetRun& runs) {
    label_spaces_.emplace(dataset.name(), dataset.labelSpace());
    ++seeds_[dataset.name()];
    const Evaluator evaluator(dataset.name(), seed, dataset.labelSpace(), dataset.groundTruth(),
                              experiment_.evaluation);
    for (const MethodRun& run : runs.methods) {
      if (!run.prediction) continue;
      try {
        outcome_.result.evaluations.push_back(evaluator.evaluate(*run.prediction));
      } catch (const std::exception& error) {
        fail(fmt::format("{}, seed {}, {}: {}", dataset.name(), seed, run.method, error.what()));
      }
    }
  }

  void addNote(const std::string& method, const std::string& note) {
    std::vector<std::string>& notes = outcome_.result.notes;
    const std::string line = methodLabel(method) + ": " + note;
    if (std::find(notes.begin(), notes.end(), line) == notes.end()) notes.push_back(line);
  }

  const ExperimentConfig& experiment_;
  std::filesystem::path folder_;
  const ExperimentEvents& events_;
  ExperimentOutcome outcome_;
  std::map<std::string, LabelSpace> label_spaces_;  ///< per dataset that is scored
  std::map<std::string, std::size_t> seeds_;        ///< worlds per dataset
  std::set<std::string> worlds_;                    ///< names and seeds seen so far
};

}  // namespace

ExperimentOutcome runExperiment(const ExperimentConfig& experiment,
                                const std::filesystem::path& folder,
                                const ExperimentEvents& events) {
  ExperimentRun run(experiment, folder, events);
  for (const ExperimentConfig::World& world : experiment.worlds) {
    try {
      run.mapWorld(world);
    } catch (const std::exception& error) {
      if (run.nothingDone()) throw;  // most likely a wrong path: better said at once
      run.fail(fmt::format("{}: {}", world.config.string(), error.what()));
    }
  }
  run.poolSeeds();
  return run.take();
}

}  // namespace hydrabench

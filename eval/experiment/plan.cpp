// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/experiment/plan.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include <fmt/format.h>

#include "core/config/plain_name.h"
#include "core/types/error.h"
#include "eval/experiment/content_hash.h"

namespace hydrabench {
namespace {

/// A manifest names files beside it.
std::filesystem::path withItsFolder(const std::filesystem::path& file) {
  const bool is_yaml = file.extension() == ".yaml" || file.extension() == ".yml";
  return is_yaml && std::filesystem::is_regular_file(file) && file.has_parent_path()
             ? file.parent_path()
             : file;
}

std::string filesStamp(const DatasetConfig& dataset) {
  ContentHash hash;
  for (const std::filesystem::path& file : dataset.files) hash.addStamp(file);
  return hash.hex();
}

/// A config as it enters a hash: files below the current folder have one spelling, however they
/// were named.
std::string withoutCurrentFolder(std::string config) {
  const std::string folder = std::filesystem::current_path().string() + "/";
  for (std::size_t at = 0; (at = config.find(folder, at)) != std::string::npos;) {
    config.erase(at, folder.size());
  }
  return config;
}

std::string decisionText(const MethodConfig& method) {
  if (!method.decision) return "";
  ConfigReader reader(ConfigDocument::fromString("{}"));
  DecisionConfig decision = *method.decision;
  read(reader, decision);
  return reader.resolved();
}

class Planner {
 public:
  explicit Planner(FrameCost cost) : cost_(cost) {}

  void add(const ExperimentConfig& experiment) {
    Plan::PlannedExperiment& planned = plan_.experiments.emplace_back();
    std::set<std::string> names;
    std::vector<std::string> files;
    for (const MethodConfig& method : experiment.methods) files.push_back(filesHash(method));
    for (const ExperimentConfig::DatasetEntry& entry : experiment.datasets) {
      Plan::PlannedDataset& dataset = planned.emplace_back();
      for (std::size_t i = 0; i < entry.numWorlds(); ++i) {
        DatasetConfig config = entry.read(i);
        if (!entry.name.empty()) config.name = entry.name;
        if (i == 0) {
          requireName(entry, config.name);
          if (!names.insert(config.name).second) {
            throw InputError(fmt::format(
                "{}: another dataset is called '{}', expected different names (give one a 'name')",
                entry.config.string(), config.name));
          }
          dataset.name = config.name;
        }
        dataset.worlds.push_back(plannedWorld(experiment, config, files));
      }
    }
  }

  Plan take() { return std::move(plan_); }

 private:
  /// Of what a method reads, read once for all experiments.
  std::string filesHash(const MethodConfig& method) {
    std::vector<std::filesystem::path> files;
    for (const std::filesystem::path& file : method.files) files.push_back(withItsFolder(file));
    std::string& known = file_hashes_[files];
    if (known.empty()) {
      ContentHash hash;
      for (const std::filesystem::path& file : files) hash.addContent(file);
      known = hash.hex();
    }
    return known;
  }

  static void requireName(const ExperimentConfig::DatasetEntry& entry, const std::string& name) {
    if (isPlainName(name)) return;
    throw InputError(
        fmt::format("{}: dataset name '{}', {}", entry.config.string(), name, kPlainNameExpected));
  }

  Plan::PlannedWorld plannedWorld(const ExperimentConfig& experiment, const DatasetConfig& config,
                                  const std::vector<std::string>& files) {
    Plan::PlannedWorld planned;
    planned.world = world(config, experiment.max_frames);
    const EvaluationConfig evaluation = pairScoring(experiment.evaluation);
    for (std::size_t m = 0; m < experiment.methods.size(); ++m) {
      const MethodConfig& method = experiment.methods[m];
      const std::string hash = run(planned.world, method, files[m]);
      planned.cells.push_back({hash, score(planned.world, method, hash, evaluation)});
    }
    return planned;
  }

  std::size_t world(const DatasetConfig& config, std::size_t max_frames) {
    const std::string key = ContentHash()
                                .add(programHash())
                                .add(withoutCurrentFolder(config.resolved_config))
                                .add(filesStamp(config))
                                .add(std::to_string(max_frames))
                                .hex();
    const auto [known, is_new] = worlds_.emplace(key, plan_.worlds.size());
    if (is_new) {
      plan_.worlds.push_back(
          {{config.name, config.seed, config.resolved_config, max_frames}, {}, {}});
      world_keys_.push_back(key);
    }
    return known->second;
  }

  std::string run(std::size_t world, const MethodConfig& method, const std::string& files) {
    const std::string hash = ContentHash()
                                 .add(cost_ == FrameCost::kTime ? "run" : "counted run")
                                 .add(world_keys_[world])
                                 .add(withoutCurrentFolder(method.mapping_config))
                                 .add(files)
                                 .hex();
    std::vector<RunUnit>& runs = plan_.worlds[world].runs;
    const auto [known, is_new] = units_.emplace(hash, runs.size());
    if (is_new) runs.push_back({hash, {}, method.mapping_config});
    std::vector<std::string>& names = runs[known->second].methods;
    if (std::find(names.begin(), names.end(), method.name) == names.end()) {
      names.push_back(method.name);
    }
    return hash;
  }

  std::string score(std::size_t world, const MethodConfig& method, const std::string& run,
                    const EvaluationConfig& evaluation) {
    const std::string decision = decisionText(method);
    const std::string hash =
        ContentHash().add("score").add(run).add(decision).add(toYaml(evaluation)).hex();
    std::vector<ScoreUnit>& scores = plan_.worlds[world].scores;
    if (units_.emplace(hash, scores.size()).second) {
      scores.push_back({hash, run, method.name, decision, evaluation});
    }
    return hash;
  }

  FrameCost cost_;
  Plan plan_;
  std::map<std::string, std::size_t> worlds_;  ///< index by key
  std::vector<std::string> world_keys_;
  std::map<std::vector<std::filesystem::path>, std::string> file_hashes_;
  std::map<std::string, std::size_t> units_;  ///< index within its world by hash
};

}  // namespace

Plan planOf(const std::vector<ExperimentConfig>& experiments, FrameCost cost) {
  Planner planner(cost);
  for (const ExperimentConfig& experiment : experiments) planner.add(experiment);
  return planner.take();
}

std::vector<Job> missingJobs(const Plan& plan, const UnitStore& store, std::size_t max_runs) {
  std::vector<Job> jobs;
  for (const Plan::World& world : plan.worlds) {
    // Scores go with the run that they need; those whose run is there, with the first job.
    std::vector<ScoreUnit> scores = world.scores;
    std::erase_if(scores, [&](const ScoreUnit& score) { return store.isDone(score.hash); });
    std::vector<RunUnit> runs = world.runs;
    std::erase_if(runs, [&](const RunUnit& run) { return store.isDone(run.hash); });
    const auto takeScores = [&](Job& job, const auto& belongs) {
      const auto rest = std::stable_partition(scores.begin(), scores.end(), belongs);
      job.scores.insert(job.scores.end(), scores.begin(), rest);
      scores.erase(scores.begin(), rest);
    };
    std::vector<Job> of_world;
    for (std::size_t begin = 0; begin < runs.size(); begin += max_runs) {
      Job& job = of_world.emplace_back();
      job.world = world.spec;
      job.runs.assign(
          runs.begin() + static_cast<std::ptrdiff_t>(begin),
          runs.begin() + static_cast<std::ptrdiff_t>(std::min(begin + max_runs, runs.size())));
      takeScores(job, [&](const ScoreUnit& score) {
        return std::any_of(job.runs.begin(), job.runs.end(),
                           [&](const RunUnit& run) { return run.hash == score.run; });
      });
    }
    if (!scores.empty()) {
      if (of_world.empty()) of_world.push_back({world.spec, {}, {}});
      takeScores(of_world.front(), [](const ScoreUnit&) { return true; });
    }
    std::move(of_world.begin(), of_world.end(), std::back_inserter(jobs));
  }
  return jobs;
}

}  // namespace hydrabench

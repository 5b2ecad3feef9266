// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/experiment/experiment_config.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include <fmt/format.h>

#include "core/config/config_reader.h"
#include "core/types/error.h"

namespace hydrabench {
namespace {

/// Overrides sorted by whom they are for.
struct Overrides {
  std::vector<std::string> datasets;
  std::map<std::string, std::vector<std::string>> methods;
  std::vector<std::string> experiment;
};

Overrides sorted(const std::vector<std::string>& assignments) {
  Overrides overrides;
  for (const std::string& assignment : assignments) {
    if (assignment.starts_with("dataset.")) {
      overrides.datasets.push_back(assignment.substr(8));
    } else if (assignment.starts_with("methods.") && !std::isdigit(assignment[8])) {
      const std::size_t dot = assignment.find('.', 8);
      if (dot == std::string::npos) {
        throw InputError(fmt::format("--set {}: expected methods.NAME.KEY=VALUE", assignment));
      }
      overrides.methods[assignment.substr(8, dot - 8)].push_back(assignment.substr(dot + 1));
    } else {
      overrides.experiment.push_back(assignment);
    }
  }
  return overrides;
}

/// Where the file of an entry lies; a fault where it does not.
std::filesystem::path requiredFile(ConfigReader& entry) {
  std::filesystem::path path;
  entry.require("config");
  entry.path("config", path);
  if (!path.empty() && !std::filesystem::exists(path)) {
    entry.fault("config", fmt::format("no such file: {}", path.string()));
  }
  return path;
}

void append(const std::vector<std::string>& more, std::vector<std::string>& list) {
  list.insert(list.end(), more.begin(), more.end());
}

}  // namespace

OpenedDataset ExperimentConfig::open(const World& world) const {
  return openDataset(world.config, world.overrides);
}

ExperimentConfig readExperiment(const std::filesystem::path& config,
                                const std::vector<std::string>& assignments) {
  Overrides overrides = sorted(assignments);
  ConfigDocument document = ConfigDocument::fromFile(config);
  for (const std::string& assignment : overrides.experiment) document.set(assignment);
  ConfigReader reader(document);

  ExperimentConfig experiment;
  experiment.name = config.stem().string();
  reader.field("name", experiment.name);
  int max_frames = 0;
  reader.field("max_frames", max_frames, {0, 1e9});
  experiment.max_frames = static_cast<std::size_t>(max_frames);

  reader.require("datasets");
  for (ConfigReader& entry : reader.list("datasets")) {
    ExperimentConfig::World world;
    world.config = requiredFile(entry);
    entry.field("set", world.overrides);
    append(overrides.datasets, world.overrides);
    std::vector<int> seeds;
    entry.field("seeds", seeds, {0, 2147483647});
    if (std::set<int>(seeds.begin(), seeds.end()).size() != seeds.size()) {
      entry.fault("seeds", "a seed occurs twice");
    }
    if (seeds.empty()) experiment.worlds.push_back(world);
    for (const int seed : seeds) {
      experiment.worlds.push_back(world);
      experiment.worlds.back().overrides.push_back(fmt::format("seed={}", seed));
    }
  }

  struct MethodEntry {
    std::filesystem::path config;
    std::vector<std::string> overrides;
  };
  std::vector<MethodEntry> method_entries;
  reader.require("methods");
  for (ConfigReader& entry : reader.list("methods")) {
    MethodEntry method{requiredFile(entry), {}};
    std::string name;
    entry.field("name", name);
    entry.field("set", method.overrides);
    if (!name.empty()) method.overrides.push_back("name=" + name);
    method_entries.push_back(std::move(method));
  }
  auto evaluation = reader.section("evaluation");
  read(evaluation, experiment.evaluation);
  reader.finish();
  experiment.resolved_config = reader.resolved();

  std::set<std::string> names;
  for (MethodEntry& entry : method_entries) {
    // Its name is known only once it is read.
    const std::string name = readMethod(entry.config, entry.overrides).name;
    if (const auto own = overrides.methods.find(name); own != overrides.methods.end()) {
      append(own->second, entry.overrides);
    }
    experiment.methods.push_back(readMethod(entry.config, entry.overrides));
    if (!names.insert(experiment.methods.back().name).second) {
      throw InputError(fmt::format(
          "{}: methods: name '{}' occurs twice, expected different names (give one a 'name')",
          config.string(), experiment.methods.back().name));
    }
  }
  for (const auto& [name, list] : overrides.methods) {
    if (names.contains(name)) continue;
    const std::string guess = didYouMean(name, {names.begin(), names.end()});
    throw InputError(fmt::format(
        "--set methods.{}.{}: no method '{}' in {}; {}", name, list.front(), name, config.string(),
        guess.empty() ? fmt::format("there are: {}", fmt::join(names, ", "))
                      : fmt::format("did you mean '{}'?", guess)));
  }
  if (experiment.worlds.empty() || experiment.methods.empty()) {
    throw InputError(
        fmt::format("{}: expected at least one dataset and one method", config.string()));
  }
  return experiment;
}

}  // namespace hydrabench

// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/experiment/experiment_config.h"

#include <map>
#include <set>
#include <utility>

#include <fmt/format.h>

#include "core/config/config_reader.h"
#include "core/config/plain_name.h"
#include "core/types/error.h"

namespace hydrabench {
namespace {

/// Overrides sorted by whom they are for.
struct Overrides {
  std::vector<std::string> datasets;
  std::map<std::string, std::vector<std::string>> methods;
  std::vector<std::string> experiment;
};

bool isDigit(char c) { return c >= '0' && c <= '9'; }

/// Whether KEY=VALUE follows the prefix.
void requireAssignment(const std::string& assignment, std::size_t prefix) {
  const std::size_t equals = assignment.find('=', prefix);
  if (equals == std::string::npos || equals == prefix) {
    throw InputError(
        fmt::format("--set {}: expected {}KEY=VALUE", assignment, assignment.substr(0, prefix)));
  }
}

Overrides sorted(const std::vector<std::string>& assignments) {
  Overrides overrides;
  for (const std::string& assignment : assignments) {
    if (assignment.starts_with("dataset.")) {
      requireAssignment(assignment, 8);
      overrides.datasets.push_back(assignment.substr(8));
    } else if (assignment.starts_with("methods.") && !isDigit(assignment[8])) {
      const std::size_t dot = assignment.find('.', 8);
      if (dot == std::string::npos) {
        throw InputError(fmt::format("--set {}: expected methods.NAME.KEY=VALUE", assignment));
      }
      requireAssignment(assignment, dot + 1);
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

std::string readName(ConfigReader& entry) {
  std::string name;
  entry.field("name", name);
  if (!name.empty() && !isPlainName(name)) {
    entry.fault("name", fmt::format("'{}', {}", name, kPlainNameExpected));
  }
  return name;
}

void append(const std::vector<std::string>& more, std::vector<std::string>& list) {
  list.insert(list.end(), more.begin(), more.end());
}

}  // namespace

std::vector<ExperimentConfig::DatasetEntry> readDatasetEntries(
    ConfigReader& reader, const std::vector<std::string>& overrides) {
  std::vector<ExperimentConfig::DatasetEntry> entries;
  std::set<std::pair<std::filesystem::path, std::string>> known;
  reader.require("datasets");
  for (ConfigReader& item : reader.list("datasets")) {
    ExperimentConfig::DatasetEntry entry;
    entry.config = requiredFile(item);
    entry.name = readName(item);
    item.field("set", entry.overrides);
    append(overrides, entry.overrides);
    item.field("seeds", entry.seeds, {0, 2147483647});
    if (std::set<int>(entry.seeds.begin(), entry.seeds.end()).size() != entry.seeds.size()) {
      item.fault("seeds", "a seed occurs twice");
    }
    if (!known.emplace(entry.config, entry.name).second) {
      item.fault("name", "the dataset occurs twice, expected different names");
    }
    for (const std::string& assignment : entry.overrides) {
      if (!entry.seeds.empty() && assignment.starts_with("seed=")) {
        item.fault("seeds", fmt::format("dataset.{} says something else; set datasets.{}.seeds",
                                        assignment, entries.size()));
      }
    }
    entries.push_back(std::move(entry));
  }
  return entries;
}

namespace {

struct MethodEntry {
  std::filesystem::path config;
  std::vector<std::string> overrides;
};

std::vector<MethodEntry> readMethodEntries(ConfigReader& reader) {
  std::vector<MethodEntry> entries;
  reader.require("methods");
  for (ConfigReader& item : reader.list("methods")) {
    MethodEntry entry{requiredFile(item), {}};
    const std::string name = readName(item);
    item.field("set", entry.overrides);
    if (!name.empty()) entry.overrides.push_back("name=" + name);
    entries.push_back(std::move(entry));
  }
  return entries;
}

/// Faults of overrides say which entry of the experiment they belong to.
template <typename Action>
auto inEntry(const std::string& entry, const Action& action) {
  try {
    return action();
  } catch (const InputError& error) {
    const std::string message = error.what();
    if (!message.starts_with("--set ")) throw;
    throw InputError(fmt::format("{}: {}", entry, message.substr(6)));
  }
}

std::vector<MethodConfig> readMethods(const std::string& file, std::vector<MethodEntry> entries,
                                      const Overrides& overrides) {
  std::vector<MethodConfig> methods;
  std::set<std::string> names;
  for (std::size_t i = 0; i < entries.size(); ++i) {
    const auto readEntry = [&] {
      return inEntry(fmt::format("{}: methods.{}", file, i),
                     [&] { return readMethod(entries[i].config, entries[i].overrides); });
    };
    MethodConfig method = readEntry();
    if (const auto own = overrides.methods.find(method.name); own != overrides.methods.end()) {
      append(own->second, entries[i].overrides);
      method = readEntry();
    }
    if (!names.insert(method.name).second) {
      throw InputError(fmt::format(
          "{}: methods: name '{}' occurs twice, expected different names (give one a 'name')", file,
          method.name));
    }
    methods.push_back(std::move(method));
  }
  for (const auto& [name, list] : overrides.methods) {
    if (names.contains(name)) continue;
    const std::string guess = didYouMean(name, {names.begin(), names.end()});
    throw InputError(
        fmt::format("--set methods.{}.{}: no method '{}' in {}; {}", name, list.front(), name, file,
                    guess.empty() ? fmt::format("there are: {}", fmt::join(names, ", "))
                                  : fmt::format("did you mean '{}'?", guess)));
  }
  return methods;
}

}  // namespace

DatasetConfig ExperimentConfig::DatasetEntry::read(std::size_t index) const {
  const std::string place = name.empty() ? config.string() : name;
  const InputError no_seed(
      fmt::format("{}: not a generated world, expected no 'seeds' in the experiment", place));
  std::vector<std::string> all = overrides;
  if (!seeds.empty()) all.push_back(fmt::format("seed={}", seeds[index]));
  try {
    DatasetConfig dataset = inEntry(place, [&] { return readDataset(config, all); });
    if (!seeds.empty() && !dataset.generated) throw no_seed;
    return dataset;
  } catch (const InputError& error) {
    const bool no_such_key =
        std::string(error.what()).find(": seed: unknown key") != std::string::npos;
    if (!seeds.empty() && no_such_key) throw no_seed;
    throw;
  }
}

ExperimentConfig readExperiment(const std::filesystem::path& config,
                                const std::vector<std::string>& assignments) {
  const Overrides overrides = sorted(assignments);
  ConfigDocument document = ConfigDocument::fromFile(config);
  for (const std::string& assignment : overrides.experiment) document.set(assignment);
  ConfigReader reader(document);
  if (!reader.has("methods") && (reader.has("estimators") || reader.has("experiment"))) {
    const bool estimates = reader.has("estimators");
    throw InputError(
        fmt::format("{0}: a {1}, expected an experiment with methods; 'hydrabench {2} {0}' runs it",
                    config.string(), estimates ? "study of shape estimators" : "sweep",
                    estimates ? "estimate" : "sweep"));
  }

  ExperimentConfig experiment;
  experiment.name = config.stem().string();
  reader.field("name", experiment.name);
  int max_frames = 0;
  reader.field("max_frames", max_frames, {0, 1e9});
  experiment.max_frames = static_cast<std::size_t>(max_frames);
  experiment.datasets = readDatasetEntries(reader, overrides.datasets);
  const std::vector<MethodEntry> method_entries = readMethodEntries(reader);
  auto evaluation = reader.section("evaluation");
  read(evaluation, experiment.evaluation);
  reader.finish();
  experiment.resolved_config = reader.resolved();
  experiment.methods = readMethods(config.string(), method_entries, overrides);
  if (experiment.datasets.empty() || experiment.methods.empty()) {
    throw InputError(
        fmt::format("{}: expected at least one dataset and one method", config.string()));
  }
  return experiment;
}

}  // namespace hydrabench

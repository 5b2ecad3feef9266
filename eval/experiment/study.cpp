// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/experiment/study.h"

#include <algorithm>
#include <set>

#include <fmt/format.h>

#include "core/config/config_reader.h"
#include "core/config/plain_name.h"
#include "core/types/error.h"

namespace hydrabench {
namespace {

constexpr const char* kOwnKeys[] = {"name", "experiment", "type", "method", "axes"};

/// Whether an override is for the sweep and not for its experiment.
bool isOwn(const std::string& assignment) {
  const std::string key = assignment.substr(0, assignment.find_first_of(".="));
  return std::find(std::begin(kOwnKeys), std::end(kOwnKeys), key) != std::end(kOwnKeys);
}

std::string filledIn(std::string assignment, const std::string& value) {
  const std::size_t place = assignment.find("{}");
  return assignment.replace(place, 2, value);
}

SweepAxis readAxis(ConfigReader& reader) {
  SweepAxis axis;
  reader.require("name");
  reader.field("name", axis.name);
  axis.title = axis.name;
  reader.field("title", axis.title);
  reader.require("values");
  reader.field("values", axis.values);
  reader.require("set");
  reader.field("set", axis.set);
  if (!axis.name.empty() && !isPlainName(axis.name)) {
    reader.fault("name", fmt::format("'{}', {}", axis.name, kPlainNameExpected));
  }
  if (reader.has("values") && axis.values.empty()) reader.fault("values", "empty");
  if (std::set<std::string>(axis.values.begin(), axis.values.end()).size() != axis.values.size()) {
    reader.fault("values", "a value occurs twice");
  }
  for (const std::string& assignment : axis.set) {
    if (assignment.find("{}") == std::string::npos) {
      reader.fault("set",
                   fmt::format("'{}', expected KEY={{}}, {{}} standing for the value", assignment));
    }
  }
  return axis;
}

/// Every combination of values, the last axis changing fastest.
std::vector<std::vector<std::string>> grid(const std::vector<SweepAxis>& axes) {
  std::vector<std::vector<std::string>> points = {{}};
  for (const SweepAxis& axis : axes) {
    std::vector<std::vector<std::string>> longer;
    for (const std::vector<std::string>& point : points) {
      for (const std::string& value : axis.values) {
        longer.push_back(point);
        longer.back().push_back(value);
      }
    }
    points = std::move(longer);
  }
  return points;
}

/// Looks at the first point only: the grid may be too large to lay out.
template <typename ExperimentAt>
void requireFew(const std::vector<SweepAxis>& axes, const ExperimentAt& experiment_at,
                std::size_t max_runs, const std::filesystem::path& place) {
  double points = 1;
  std::string product;
  std::vector<std::string> first;
  for (const SweepAxis& axis : axes) {
    points *= static_cast<double>(axis.values.size());
    product += fmt::format("{}{}", product.empty() ? "" : " x ", axis.values.size());
    first.push_back(axis.values.front());
  }
  const ExperimentConfig experiment = experiment_at(first);
  std::size_t worlds = 0;
  for (const ExperimentConfig::DatasetEntry& entry : experiment.datasets) {
    worlds += entry.numWorlds();
  }
  const double per_point = static_cast<double>(experiment.methods.size() * worlds);
  if (points * per_point <= static_cast<double>(max_runs)) return;
  throw InputError(
      fmt::format("{}: axes: {} points of {} runs each are {} runs; expected at most {}, or --yes",
                  place.string(), product, per_point, points * per_point, max_runs));
}

Study plainExperiment(const std::filesystem::path& config,
                      const std::vector<std::string>& overrides) {
  Study study;
  study.points.push_back({{}, readExperiment(config, overrides)});
  study.name = study.points.front().experiment.name;
  study.resolved_config = study.points.front().experiment.resolved_config;
  return study;
}

void keepOnly(const std::string& method, ExperimentConfig& experiment,
              const std::filesystem::path& place) {
  std::vector<std::string> names;
  for (const MethodConfig& candidate : experiment.methods) names.push_back(candidate.name);
  std::erase_if(experiment.methods,
                [&](const MethodConfig& candidate) { return candidate.name != method; });
  if (experiment.methods.empty()) {
    const std::string guess = didYouMean(method, names);
    throw InputError(fmt::format("{}: method: no '{}' in the experiment{}", place.string(), method,
                                 guess.empty() ? "" : fmt::format("; did you mean '{}'?", guess)));
  }
  if (!experiment.methods.front().decision) {
    throw InputError(
        fmt::format("{}: method: '{}' keeps no candidates, expected a method that "
                    "estimates shapes",
                    place.string(), method));
  }
}

}  // namespace

std::vector<ExperimentConfig> Study::experiments() const {
  std::vector<ExperimentConfig> experiments;
  for (const Point& point : points) experiments.push_back(point.experiment);
  return experiments;
}

Study readStudy(const std::filesystem::path& config, const std::vector<std::string>& overrides,
                std::size_t max_runs) {
  ConfigDocument document = ConfigDocument::fromFile(config);
  if (!ConfigReader(document).has("experiment")) return plainExperiment(config, overrides);

  std::vector<std::string> for_experiment;
  for (const std::string& assignment : overrides) {
    if (isOwn(assignment)) {
      document.set(assignment);
    } else {
      for_experiment.push_back(assignment);
    }
  }
  ConfigReader reader(document);
  Study study;
  study.name = config.stem().string();
  reader.field("name", study.name);
  std::filesystem::path experiment;
  reader.path("experiment", experiment);
  std::string type = "grid";
  reader.choice("type", type, {"grid", "tau_o"});
  if (type == "tau_o") {
    study.tau_o_method = "hydra_plus_plus";
    reader.field("method", study.tau_o_method);
  } else {
    reader.require("axes");
    for (ConfigReader& item : reader.list("axes")) study.axes.push_back(readAxis(item));
    if (reader.has("axes") && study.axes.empty()) reader.fault("axes", "empty");
  }
  reader.finish();
  study.resolved_config = reader.resolved();
  const auto experiment_at = [&](const std::vector<std::string>& values) {
    std::vector<std::string> assignments = for_experiment;
    for (std::size_t a = 0; a < study.axes.size(); ++a) {
      for (const std::string& assignment : study.axes[a].set) {
        assignments.push_back(filledIn(assignment, values[a]));
      }
    }
    return readExperiment(experiment, assignments);
  };
  if (max_runs > 0) requireFew(study.axes, experiment_at, max_runs, config);
  for (const std::vector<std::string>& values : grid(study.axes)) {
    study.points.push_back({values, experiment_at(values)});
  }
  if (!study.tau_o_method.empty()) {
    keepOnly(study.tau_o_method, study.points.front().experiment, config);
  }
  return study;
}

}  // namespace hydrabench

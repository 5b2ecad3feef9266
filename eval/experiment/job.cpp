// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/experiment/job.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "core/config/config_reader.h"
#include "core/io/atomic_file.h"
#include "core/types/error.h"
#include "eval/experiment/content_hash.h"

namespace hydrabench {
namespace {

using Json = nlohmann::ordered_json;

EvaluationConfig evaluationFrom(const std::string& yaml) {
  ConfigReader reader(ConfigDocument::fromString(yaml, "evaluation"));
  EvaluationConfig config;
  read(reader, config);
  reader.finish();
  return config;
}

Job jobFrom(const Json& json, const std::string& name) {
  if (json.at("program").get<std::string>() != programHash()) {
    throw InputError(
        fmt::format("{}: of another build of hydrabench; run its experiment or sweep again", name));
  }
  Job job;
  const Json& world = json.at("world");
  world.at("dataset").get_to(job.world.dataset);
  world.at("seed").get_to(job.world.seed);
  world.at("max_frames").get_to(job.world.max_frames);
  world.at("config").get_to(job.world.config);
  for (const Json& item : json.at("runs")) {
    RunUnit& run = job.runs.emplace_back();
    item.at("hash").get_to(run.hash);
    item.at("methods").get_to(run.methods);
    item.at("config").get_to(run.mapping_config);
  }
  for (const Json& item : json.at("scores")) {
    ScoreUnit& score = job.scores.emplace_back();
    item.at("hash").get_to(score.hash);
    item.at("run").get_to(score.run);
    item.at("method").get_to(score.method);
    item.at("decision").get_to(score.decision);
    score.evaluation = evaluationFrom(item.at("evaluation").get<std::string>());
  }
  return job;
}

}  // namespace

EvaluationConfig pairScoring(EvaluationConfig config) {
  config.kappas.clear();
  config.kappa_max = EvaluationConfig().kappa_max;
  config.bootstrap_resamples = 0;
  return config;
}

std::string Job::label() const {
  std::vector<std::string> names;
  for (const RunUnit& run : runs) {
    names.push_back(fmt::to_string(fmt::join(run.methods, " + ")));
  }
  if (runs.empty()) {
    for (const ScoreUnit& score : scores) names.push_back(score.method);
  }
  return fmt::format("{}, seed {}: {}", world.dataset, world.seed, fmt::join(names, ", "));
}

std::string jobJson(const Job& job) {
  Json runs = Json::array();
  for (const RunUnit& run : job.runs) {
    runs.push_back({{"hash", run.hash}, {"methods", run.methods}, {"config", run.mapping_config}});
  }
  Json scores = Json::array();
  for (const ScoreUnit& score : job.scores) {
    scores.push_back({{"hash", score.hash},
                      {"run", score.run},
                      {"method", score.method},
                      {"decision", score.decision},
                      {"evaluation", toYaml(score.evaluation)}});
  }
  const Json json = {{"program", programHash()},
                     {"world",
                      {{"dataset", job.world.dataset},
                       {"seed", job.world.seed},
                       {"max_frames", job.world.max_frames},
                       {"config", job.world.config}}},
                     {"runs", runs},
                     {"scores", scores}};
  return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

Job jobFromJson(const std::string& text, const std::string& name) {
  try {
    const Json json = Json::parse(text);
    return jobFrom(json.contains("job") ? json.at("job") : json, name);
  } catch (const nlohmann::json::exception& error) {
    throw InputError(fmt::format("{}: not a job: {}", name, error.what()));
  }
}

Job readJob(const std::filesystem::path& path) { return jobFromJson(readFile(path), path); }

}  // namespace hydrabench

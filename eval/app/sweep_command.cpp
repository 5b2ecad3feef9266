// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include <CLI/App.hpp>
#include <fmt/format.h>

#include "core/graph/spark_dsg_json.h"
#include "core/io/atomic_file.h"
#include "core/types/error.h"
#include "eval/app/app.h"
#include "eval/app/progress.h"
#include "eval/experiment/result_worlds.h"
#include "eval/experiment/tau_o_sweep.h"
#include "eval/report/result_folder.h"

namespace hydrabench {
namespace {

struct Options {
  std::filesystem::path sweep;
  std::filesystem::path result;
  std::filesystem::path out;
  std::vector<std::string> overrides;
  bool replace = false;
};

struct SweepConfig {
  std::string type = "tau_o";
  std::string method = "hydra_plus_plus";
  EvaluationConfig evaluation;
  std::string resolved;
};

SweepConfig readSweep(const Options& options) {
  ConfigDocument document = ConfigDocument::fromFile(options.sweep);
  for (const std::string& assignment : options.overrides) document.set(assignment);
  ConfigReader reader(document);
  SweepConfig config;
  reader.require("type");
  reader.choice("type", config.type, {"tau_o"});
  reader.field("method", config.method);
  auto evaluation = reader.section("evaluation");
  read(evaluation, config.evaluation);
  reader.finish();
  config.resolved = reader.resolved();
  return config;
}

/// The worlds of one dataset: they are scored together.
struct DatasetWorlds {
  std::vector<TauOWorld> worlds;
  std::vector<std::unique_ptr<const Evaluator>> evaluators;
  DecisionConfig decision;
};

int sweep(const Options& options) {
  const SweepConfig config = readSweep(options);
  AtomicFolder folder(options.out, options.replace ? kResultMarker : "");
  const std::vector<ResultWorld> worlds = resultWorlds(options.result);
  const auto isChosen = [&](const std::filesystem::path& path) {
    return path.filename() == config.method;
  };
  if (std::none_of(worlds.begin(), worlds.end(), [&](const ResultWorld& world) {
        return std::any_of(world.predictions.begin(), world.predictions.end(), isChosen);
      })) {
    throw InputError(
        fmt::format("{}: no prediction of '{}' in there", options.result.string(), config.method));
  }
  std::vector<std::string> order;
  std::map<std::string, DatasetWorlds> datasets;
  Progress progress("read", worlds.size());
  for (const ResultWorld& world : worlds) {
    for (const std::filesystem::path& path : world.predictions) {
      if (!isChosen(path)) continue;
      Prediction prediction = readPrediction(path);
      if (prediction.candidates.empty()) {
        throw InputError(
            fmt::format("{}: no candidates in there, expected those of a method that "
                        "estimates shapes",
                        path.string()));
      }
      if (!datasets.contains(world.dataset)) order.push_back(world.dataset);
      DatasetWorlds& of = datasets[world.dataset];
      of.decision = readDecisionOf(path);
      const OpenedDataset opened = world.open();
      of.evaluators.push_back(
          std::make_unique<const Evaluator>(world.dataset, world.seed, opened.dataset->labelSpace(),
                                            opened.dataset->groundTruth(), config.evaluation));
      of.worlds.push_back({std::move(prediction.candidates), of.evaluators.back().get()});
    }
    progress.advance();
  }
  for (const std::string& dataset : order) {
    const DatasetWorlds& of = datasets.at(dataset);
    const double used = of.decision.rmcc.min_overlap;
    const std::vector<TauOStep> steps = sweepTauO(of.worlds, of.decision, config.evaluation);
    const std::string name = "tau_o_" + dataset;
    writeFileAtomic(folder.temporary() / (name + ".csv"), tauOCsv(steps));
    const std::string summary = tauOMarkdown(steps, used);
    writeFileAtomic(folder.temporary() / (name + ".md"), summary);
    for (const Matching matching : {Matching::kExists, Matching::kOneToOne}) {
      const std::string remark =
          drawPlot(tauOPlot(steps, matching, used), folder.temporary() / "plots",
                   fmt::format("{}_{}", name, hydrabench::name(matching)));
      if (!remark.empty()) fmt::print(stderr, "plots/{}\n", remark);
    }
    fmt::print("{}, {}: worlds: {}, thresholds at which something changes: {}\n\n{}\n", dataset,
               config.method, of.worlds.size(), steps.size(), summary);
  }
  writeFileAtomic(folder.temporary() / "config.yaml", config.resolved);
  writeFileAtomic(folder.temporary() / kResultMarker,
                  provenanceJson(currentProvenance(commandLine())));
  folder.commit();
  fmt::print("wrote {}\n", options.out.string());
  return kDone;
}

}  // namespace

Command addSweep(CLI::App& app) {
  auto options = std::make_shared<Options>();
  app.add_option("sweep", options->sweep, "what to sweep (configs/sweeps/*.yaml)")
      ->required()
      ->type_name("SWEEP.yaml");
  app.add_option("result", options->result, "result folder of 'run' with the candidates")
      ->required()
      ->type_name("RESULT");
  app.add_option("--out", options->out, "folder to write: tables and plots")
      ->required()
      ->type_name("DIR");
  app.add_flag("--replace", options->replace, "replace the folder if it exists");
  addOverrides(app, options->overrides, "method=hydra_plus_plus_refined");
  app.footer(
      "type: tau_o decides the candidates of a run anew for every threshold of the consistency\n"
      "check: an exact step function, no mapping.");
  return [options] { return sweep(*options); };
}

}  // namespace hydrabench

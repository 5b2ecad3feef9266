// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <filesystem>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <unistd.h>
#include <vector>

#include <CLI/App.hpp>
#include <fmt/format.h>

#include "core/io/atomic_file.h"
#include "core/types/error.h"
#include "eval/app/app.h"
#include "eval/app/execution.h"
#include "eval/app/remarks.h"
#include "eval/experiment/assemble.h"
#include "eval/report/comparison_table.h"

namespace hydrabench {
namespace {

struct Options {
  std::filesystem::path experiment;
  std::filesystem::path out;
  std::vector<std::string> overrides;
  bool replace = false;
  Execution execution;
};

void printTables(const Result& result, const std::map<std::string, double>& frame_period_s) {
  if (!result.evaluations.empty()) {
    const std::vector<ScoreRow> scores = allScores(result);
    std::set<std::string> pooled;
    for (const MethodEvaluation& evaluation : result.evaluations) {
      if (evaluation.seed == kPooledSeed) pooled.insert(evaluation.dataset);
    }
    for (const MethodEvaluation& evaluation : result.evaluations) {
      const bool in_table = evaluation.seed == kPooledSeed || !pooled.contains(evaluation.dataset);
      if (in_table) printRemarks(evaluation);
    }
    fmt::print("{}\n", renderTerminal(comparisonTable(scores, kAllMicro, result.notes),
                                      isatty(STDOUT_FILENO) == 1));
  }
  if (result.timing.empty()) return;
  double peak_mib = 0;
  for (const TimingRow& row : result.timing) peak_mib = std::max(peak_mib, row.peak_rss_mib);
  fmt::print("{}peak memory {:.0f} MiB\n", timingSummary(result.timing, frame_period_s), peak_mib);
}

int run(const Options& options) {
  const Provenance provenance = currentProvenance(commandLine());
  const std::vector<ExperimentConfig> experiments = {
      readExperiment(options.experiment, options.overrides)};
  const ExperimentConfig& experiment = experiments.front();
  const Plan plan =
      planOf(experiments,
             options.execution.count_instructions ? FrameCost::kInstructions : FrameCost::kTime);
  AtomicFolder folder(options.out, replaceableMarker(options.out, options.replace));
  carryOut(plan, options.execution);

  const UnitStore store = options.execution.store();
  const Plan::PlannedExperiment& planned = plan.experiments.front();
  ExperimentOutcome outcome = assembled(experiment, planned, plan, store);
  tellFailures(outcome.failures, options.execution, folder.temporary());
  if (outcome.predictions == 0) {
    throw InputError(fmt::format("{}: every method failed on every dataset; nothing was written",
                                 options.experiment.string()));
  }
  outcome.result.provenance = provenance;
  const Result& result = outcome.result;
  printTables(result, outcome.frame_period_s);
  linkPredictions(experiment, planned, plan, store, folder.temporary());
  for (const std::string& remark : writeResult(folder, result)) {
    fmt::print(stderr, "{}\n", remark);
  }
  fmt::print("wrote {}\n", options.out.string());
  return outcome.failures.empty() ? kDone : kPartlyFailed;
}

}  // namespace

Command addRun(CLI::App& app) {
  auto options = std::make_shared<Options>();
  app.add_option("experiment", options->experiment,
                 "what to run on what (configs/experiments/*.yaml)")
      ->required()
      ->type_name("EXPERIMENT.yaml");
  app.add_option("--out", options->out, "result folder to write")->required()->type_name("RESULT");
  app.add_flag("--replace", options->replace, "replace the result folder if it exists");
  addOverrides(app, options->overrides, "methods.hydra.objects.cluster_tolerance_m=0.2");
  addExecution(app, options->execution);
  app.add_flag("--count-instructions", options->execution.count_instructions,
               "count the instructions of every frame instead of timing it (valgrind, one thread, "
               "many times slower): what 'compare' tells apart on any busy machine");
  app.footer(
      "Keys: dataset.KEY for every dataset, methods.NAME.KEY for a method, evaluation.KEY,\n"
      "datasets.0.seeds=[1,2] and the like for the experiment itself.\n"
      "RESULT holds the table (md, tex, csv, json), scores.csv, objects.csv, timing.csv, the\n"
      "predictions and what made them. Where a dataset has no ground truth the methods are run "
      "and\n"
      "timed only. What is finished stands in the store: stopped and started again, the command\n"
      "goes on where it was. Exit code 4: something failed, the rest is kept.");
  return [options] { return run(*options); };
}

}  // namespace hydrabench

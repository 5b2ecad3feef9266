// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <unistd.h>
#include <utility>
#include <vector>

#include <CLI/App.hpp>
#include <fmt/format.h>

#include "core/graph/candidate_io.h"
#include "core/io/atomic_file.h"
#include "core/parallel/parallel_for.h"
#include "core/types/error.h"
#include "eval/app/app.h"
#include "eval/app/execution.h"
#include "eval/evaluation/evaluation_io.h"
#include "eval/experiment/study.h"
#include "eval/experiment/tau_o_sweep.h"
#include "eval/report/comparison_table.h"
#include "eval/report/result_folder.h"
#include "eval/report/sweep_report.h"

namespace hydrabench {
namespace {

struct Options {
  std::filesystem::path sweep;
  std::filesystem::path out;
  std::vector<std::string> overrides;
  bool replace = false;
  Execution execution;
  bool yes = false;
};

void draw(const Plot& plot, const std::filesystem::path& folder, const std::string& name) {
  const std::string remark = drawPlot(plot, folder / "plots", name);
  if (!remark.empty()) fmt::print(stderr, "plots/{}\n", remark);
}

/// Table and plots of a grid.
void writeGrid(const Study& study, const std::vector<ExperimentOutcome>& outcomes,
               const std::filesystem::path& folder) {
  SweepScores sweep;
  for (const SweepAxis& axis : study.axes) sweep.axes.push_back({axis.name, axis.title});
  for (std::size_t i = 0; i < outcomes.size(); ++i) {
    sweep.points.push_back({study.points[i].values, allScores(outcomes[i].result)});
  }
  const ComparisonTable table = sweepTable(sweep);
  fmt::print("{}\n", renderTerminal(table, isatty(STDOUT_FILENO) == 1));
  writeFileAtomic(folder / "scores.csv", sweepCsv(sweep));
  writeTable(folder, table);
  for (const std::string& dataset : sweepDatasets(sweep)) {
    for (const Matching matching : {Matching::kExists, Matching::kOneToOne}) {
      draw(sweepPlot(sweep, dataset, name(matching)), folder,
           fmt::format("{}_{}_{}", study.name, dataset, name(matching)));
    }
  }
}

/// The exact sweep of tau_O over the candidates of the one method there is.
void writeTauO(const Study& study, const Plan& plan, const UnitStore& store,
               const std::filesystem::path& folder) {
  const ExperimentConfig& experiment = study.points.front().experiment;
  const DecisionConfig& decision = *experiment.methods.front().decision;
  const double used = decision.rmcc.min_overlap;
  for (const Plan::PlannedDataset& dataset : plan.experiments.front()) {
    std::vector<std::optional<TauOWorld>> read(dataset.worlds.size());
    parallelFor(read.size(), [&](std::size_t i) {
      const Plan::Cell& cell = dataset.worlds[i].cells.front();
      if (!store.isDone(cell.run) || !store.isDone(cell.score)) return;
      const MethodEvaluation evaluation = readEvaluation(store.scoreFile(cell.score));
      if (!evaluation.isScored()) return;
      read[i] = {readCandidates(store.runFolder(cell.run)), countingOf(evaluation)};
    });
    std::vector<TauOWorld> worlds;
    for (std::optional<TauOWorld>& world : read) {
      if (world) worlds.push_back(std::move(*world));
    }
    if (worlds.empty()) continue;
    const std::vector<TauOStep> steps = sweepTauO(worlds, decision, experiment.evaluation);
    const std::string name = "tau_o_" + dataset.name;
    const std::string summary = tauOMarkdown(steps, used);
    writeFileAtomic(folder / (name + ".csv"), tauOCsv(steps));
    writeFileAtomic(folder / (name + ".md"), summary);
    for (const Matching matching : {Matching::kExists, Matching::kOneToOne}) {
      draw(tauOPlot(steps, matching, used), folder,
           fmt::format("{}_{}", name, hydrabench::name(matching)));
    }
    fmt::print("{}, {}: worlds: {}, thresholds at which something changes: {}\n\n{}\n",
               dataset.name, study.tau_o_method, worlds.size(), steps.size(), summary);
  }
}

int sweep(const Options& options) {
  const Study study = readStudy(options.sweep, options.overrides, options.yes ? 0 : kManyRuns);
  if (study.axes.empty() && study.tau_o_method.empty()) {
    throw InputError(
        fmt::format("{}: an experiment, expected a sweep with axes; 'hydrabench run' "
                    "takes experiments",
                    options.sweep.string()));
  }
  const std::vector<ExperimentConfig> experiments = study.experiments();
  const Plan plan = planOf(experiments);
  AtomicFolder folder(options.out, replaceableMarker(options.out, options.replace));
  carryOut(plan, options.execution);

  const UnitStore store = options.execution.store();
  std::vector<ExperimentOutcome> outcomes;
  std::vector<UnitFailure> failures;
  std::size_t predictions = 0;
  for (std::size_t i = 0; i < experiments.size(); ++i) {
    outcomes.push_back(
        assembled(experiments[i], plan.experiments[i], plan, store,
                  study.tau_o_method.empty() ? Scores::kAssembled : Scores::kLeftOut));
    predictions += outcomes.back().predictions;
    for (UnitFailure& failure : outcomes.back().failures) {
      for (std::size_t a = 0; a < study.axes.size(); ++a) {
        failure.unit += fmt::format(", {} {}", study.axes[a].name, study.points[i].values[a]);
      }
      failures.push_back(std::move(failure));
    }
  }
  tellFailures(failures, options.execution, folder.temporary());
  if (predictions == 0) {
    throw InputError(fmt::format("{}: every method failed on every dataset; nothing was written",
                                 options.sweep.string()));
  }
  if (study.tau_o_method.empty()) {
    writeGrid(study, outcomes, folder.temporary());
  } else {
    writeTauO(study, plan, store, folder.temporary());
  }
  writeFileAtomic(folder.temporary() / "config.yaml",
                  study.resolved_config + outcomes.front().result.config);
  writeFileAtomic(folder.temporary() / kResultMarker,
                  provenanceJson(currentProvenance(commandLine())));
  folder.commit();
  fmt::print("wrote {}\n", options.out.string());
  return failures.empty() ? kDone : kPartlyFailed;
}

}  // namespace

Command addSweep(CLI::App& app) {
  auto options = std::make_shared<Options>();
  app.add_option("sweep", options->sweep, "what to sweep (configs/sweeps/*.yaml)")
      ->required()
      ->type_name("SWEEP.yaml");
  app.add_option("--out", options->out, "folder to write: tables and plots")
      ->required()
      ->type_name("DIR");
  app.add_flag("--replace", options->replace, "replace the folder if it exists");
  app.add_flag("--yes", options->yes,
               fmt::format("do not ask back where it is more than {} runs", kManyRuns));
  addOverrides(app, options->overrides, "method=hydra_plus_plus_refined");
  addExecution(app, options->execution);
  app.footer(
      "Only what is not in the store yet is run: stopped and started again, a sweep goes on where\n"
      "it was. Keys: those of the sweep (method=..., experiment=...) and of its experiment\n"
      "(datasets.0.seeds=[1,2], dataset.KEY, methods.NAME.KEY, evaluation.KEY).\n"
      "type: tau_o decides the candidates of one method anew for every threshold of the\n"
      "consistency check: an exact step function, no mapping.\n"
      "Exit code 4: something failed, the rest is kept.");
  return [options] { return sweep(*options); };
}

}  // namespace hydrabench

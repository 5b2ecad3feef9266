// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include <array>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include <CLI/App.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "eval/app/app.h"
#include "eval/app/execution.h"
#include "eval/experiment/plan.h"
#include "eval/experiment/study.h"

namespace hydrabench {
namespace {

struct Options {
  std::filesystem::path study;
  std::vector<std::string> overrides;
  std::filesystem::path store;
  bool all = false;
  bool yes = false;
};

constexpr std::array<const char*, 4> kStates = {"done", "running", "failed", "missing"};

int status(const Options& options) {
  const Study study = readStudy(options.study, options.overrides, options.yes ? 0 : kManyRuns);
  const Plan plan = planOf(study.experiments());
  const UnitStore store(storeFolder(options.store));
  std::array<std::size_t, 4> runs{};
  std::array<std::size_t, 4> scores{};
  for (const Plan::World& world : plan.worlds) {
    const auto tell = [&](const std::string& hash, const std::string& what, auto& counts) {
      const UnitStore::State state = store.state(hash);
      ++counts[static_cast<std::size_t>(state)];
      const bool failed = state == UnitStore::State::kFailed;
      if (!options.all && !failed) return;
      fmt::print("{:<8} {}, seed {}: {}\n", kStates[static_cast<std::size_t>(state)],
                 world.spec.dataset, world.spec.seed, what);
      if (failed) {
        fmt::print("         {}\n         again: hydrabench work --store {} {}\n",
                   store.failure(hash).value_or(""), store.root().string(),
                   store.failureFile(hash).string());
      }
    };
    for (const RunUnit& run : world.runs) {
      tell(run.hash, fmt::to_string(fmt::join(run.methods, " + ")), runs);
    }
    for (const ScoreUnit& score : world.scores) {
      tell(score.hash, score.method + ", scores", scores);
    }
  }
  const auto line = [](const char* name, const std::array<std::size_t, 4>& counts) {
    fmt::print("{:<7}", name);
    for (std::size_t i = 0; i < counts.size(); ++i) fmt::print(" {:>4} {}", counts[i], kStates[i]);
    fmt::print("\n");
  };
  line("runs", runs);
  line("scores", scores);
  const std::size_t failed = runs[2] + scores[2];
  return failed == 0 ? kDone : kPartlyFailed;
}

}  // namespace

Command addStatus(CLI::App& app) {
  auto options = std::make_shared<Options>();
  app.add_option("study", options->study,
                 "experiment or sweep (configs/experiments, configs/sweeps)")
      ->required()
      ->type_name("STUDY.yaml");
  addOverrides(app, options->overrides, "methods.hydra.objects.cluster_tolerance_m=0.2");
  addStore(app, options->store);
  app.add_flag("--yes", options->yes,
               fmt::format("do not ask back where it is more than {} runs", kManyRuns));
  app.add_flag("--all", options->all, "name every unit, not only those that failed");
  app.footer("With the same --set as the command it is about. Exit code 4: something failed.");
  return [options] { return status(*options); };
}

}  // namespace hydrabench

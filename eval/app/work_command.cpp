// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include <CLI/App.hpp>
#include <fmt/format.h>

#include "eval/app/app.h"
#include "eval/app/execution.h"
#include "eval/experiment/executor.h"
#include "eval/experiment/job_runner.h"

namespace hydrabench {
namespace {

struct Options {
  std::vector<std::string> jobs;
  std::filesystem::path store;
};

int work(const Options& options) {
  const UnitStore store(storeFolder(options.store));
  if (options.jobs.size() == 1 && options.jobs.front() == "-") {
    workOnInput(store);
    return kDone;
  }
  JobRunner runner(store);
  bool failed = false;
  JobEvents events;
  events.on_world = [](const WorldSpec& world, std::size_t frames) {
    fmt::print("{}, seed {}: {} frames\n", world.dataset, world.seed, frames);
  };
  events.on_failure = [&](const std::string& unit, const std::string& message) {
    failed = true;
    fmt::print(stderr, "failed: {}: {}\n", unit, message);
  };
  for (const std::string& file : options.jobs) {
    const Job job = readJob(file);
    runner.run(job, events);
    fmt::print("{}\n", job.label());
  }
  return failed ? kPartlyFailed : kDone;
}

}  // namespace

Command addWork(CLI::App& app) {
  auto options = std::make_shared<Options>();
  app.add_option("jobs", options->jobs,
                 "files that say what to do, as failures name them; -: lines of standard input")
      ->required()
      ->type_name("JOB.json");
  addStore(app, options->store);
  app.footer(
      "What run and sweep call in processes of their own. By hand: to do a unit again that has\n"
      "failed, with the command that was printed.");
  return [options] { return work(*options); };
}

}  // namespace hydrabench

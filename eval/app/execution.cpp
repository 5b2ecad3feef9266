// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/app/execution.h"

#include <chrono>
#include <cstdio>
#include <map>
#include <thread>
#include <unistd.h>

#include <fmt/format.h>

#include "core/io/atomic_file.h"
#include "core/parallel/parallel_for.h"
#include "core/types/error.h"
#include "eval/app/progress.h"
#include "eval/experiment/executor.h"

namespace hydrabench {
namespace {

constexpr const char* kFailuresFile = "failures.txt";

/// At most so many methods share the frames of a world: all of them are in memory together.
constexpr std::size_t kRunsAtOnce = 8;

std::size_t numRuns(const std::vector<Job>& jobs) {
  std::size_t count = 0;
  for (const Job& job : jobs) count += job.runs.size();
  return count;
}

/// Runs that are done, what the workers are at, and the time left; a line that is drawn over on a
/// terminal, otherwise one at every fifth of a world.
class StudyProgress {
 public:
  explicit StudyProgress(const std::vector<Job>& jobs)
      : total_runs_(numRuns(jobs)), start_(Clock::now()) {}
  ~StudyProgress() {
    if (terminal_) fmt::print(stderr, "\r\033[K");
  }

  ExecutorEvents events() {
    ExecutorEvents events;
    events.on_world = [this](std::size_t worker, const Job& job, std::size_t frames) {
      workers_[worker] = {fmt::format("{}, seed {}", job.world.dataset, job.world.seed),
                          job.runs.size(), frames, 0, 0};
      draw(false);
    };
    events.on_frame = [this](std::size_t worker, std::size_t frame) {
      Worker& at = workers_[worker];
      at.frame = frame;
      const bool fifth = frame * 5 / std::max<std::size_t>(1, at.frames) > at.fifths;
      if (fifth) at.fifths = frame * 5 / at.frames;
      draw(fifth);
    };
    events.on_job_done = [this](const Job& job) {
      done_runs_ += job.runs.size();
      // Which worker it was does not matter: it soon says what it is at next.
      std::erase_if(workers_, [](const auto& entry) { return entry.second.isThrough(); });
      draw(true);
    };
    events.on_failure = [this](const std::string& unit, const std::string& message) {
      if (terminal_) fmt::print(stderr, "\r\033[K");
      fmt::print(stderr, "failed: {}: {}\n", unit, message);
    };
    return events;
  }

 private:
  using Clock = std::chrono::steady_clock;
  struct Worker {
    std::string world;
    std::size_t runs = 0;
    std::size_t frames = 0;
    std::size_t frame = 0;
    std::size_t fifths = 0;
    bool isThrough() const { return frame + 10 > frames; }  // every tenth frame is told
  };

  void draw(bool line) {
    const auto now = Clock::now();
    if (terminal_ ? now - last_draw_ < std::chrono::milliseconds(100) : !line) return;
    last_draw_ = now;
    double done = static_cast<double>(done_runs_);
    std::string at;
    for (const auto& [index, worker] : workers_) {
      done += static_cast<double>(worker.runs * worker.frame) / static_cast<double>(worker.frames);
      at += fmt::format("; {} {}/{}", worker.world, worker.frame, worker.frames);
    }
    const double elapsed = std::chrono::duration<double>(now - start_).count();
    const std::string left =
        done_runs_ == total_runs_ ? durationText(elapsed) + " in all"
        : done > 0
            ? durationText(elapsed * (static_cast<double>(total_runs_) - done) / done) + " left"
            : "beginning";
    fmt::print(stderr, "{}{}/{} runs, {}{}{}", terminal_ ? "\r\033[K" : "", done_runs_, total_runs_,
               left, at, terminal_ ? "" : "\n");
    std::fflush(stderr);
  }

  std::size_t total_runs_;
  std::size_t done_runs_ = 0;
  std::map<std::size_t, Worker> workers_;
  bool terminal_ = isatty(STDERR_FILENO) == 1;
  Clock::time_point start_;
  Clock::time_point last_draw_;
};

/// --threads where it was given, else 0.
int chosenThreads() {
  const int threads = numThreads();
  return threads == static_cast<int>(std::thread::hardware_concurrency()) ? 0 : threads;
}

}  // namespace

void addStore(CLI::App& app, std::filesystem::path& store) {
  app.add_option("--store", store,
                 "folder of finished units, shared by all studies; default: the environment "
                 "variable HYDRABENCH_STORE, else .hydrabench/store")
      ->type_name("DIR");
}

void addExecution(CLI::App& app, Execution& execution) {
  addStore(app, execution.store_option);
  app.add_option("--executor", execution.executor,
                 "local: processes on this machine; slurm: a job array of a cluster, the store in "
                 "a folder that all nodes see")
      ->check(CLI::IsMember({"local", "slurm"}))
      ->capture_default_str();
  app.add_option("--jobs", execution.jobs,
                 "processes at once; they share the cores, and each other's time: for timing, 1")
      ->check(CLI::Range(1, 1024))
      ->capture_default_str();
  app.add_option("--memory-limit", execution.memory_limit_mib,
                 "of each process; a unit that needs more fails, the others go on")
      ->type_name("MIB");
  app.add_option("--sbatch", execution.sbatch,
                 "option of sbatch, e.g. --sbatch partition=cpu --sbatch mem=8G; repeatable")
      ->type_name("KEY=VALUE")
      ->allow_extra_args(false)
      ->take_all();
}

void carryOut(const Plan& plan, const Execution& execution) {
  const UnitStore store = execution.store();
  std::size_t planned = 0;
  for (const Plan::World& world : plan.worlds) planned += world.runs.size();
  const bool slurm = execution.executor == "slurm";
  // Enough jobs for all processes; on a cluster each run is a task.
  const std::size_t at_once =
      slurm ? 1 : std::clamp<std::size_t>(planned / execution.jobs, 1, kRunsAtOnce);
  const std::vector<Job> jobs = missingJobs(plan, store, at_once);
  if (jobs.empty()) return;
  if (slurm && execution.count_instructions) {
    throw InputError("--count-instructions: with --executor slurm, expected --executor local");
  }
  store.requireWritable();
  const std::size_t missing = numRuns(jobs);
  if (missing < planned) {
    fmt::print(stderr, "{} of {} runs are in {}\n", planned - missing, planned,
               store.root().string());
  }
  StudyProgress progress(jobs);
  if (slurm) {
    SlurmConfig config;
    config.sbatch = execution.sbatch;
    config.threads = chosenThreads();
    executeOnSlurm(jobs, store, config, progress.events());
  } else {
    LocalConfig config;
    config.jobs = execution.jobs;
    config.threads = chosenThreads();
    config.memory_limit_mib = execution.memory_limit_mib;
    if (!execution.count_instructions)
      return executeLocally(jobs, store, config, progress.events());
    // Scores are made by a process of full speed.
    std::vector<Job> counted = jobs;
    std::vector<Job> scored = jobs;
    for (Job& job : counted) job.scores.clear();
    for (Job& job : scored) job.runs.clear();
    std::erase_if(counted, [](const Job& job) { return job.runs.empty(); });
    config.count_instructions = true;
    executeLocally(counted, store, config, progress.events());
    config.count_instructions = false;
    ExecutorEvents failures;
    failures.on_failure = progress.events().on_failure;
    executeLocally(scored, store, config, failures);
  }
}

void tellFailures(const std::vector<UnitFailure>& failures, const Execution& execution,
                  const std::filesystem::path& folder) {
  if (failures.empty()) return;
  std::string text;
  fmt::print(stderr, "{} failed:\n", failures.size());
  for (const UnitFailure& failure : failures) {
    const bool by_hand = !failure.job.empty() && !execution.count_instructions;
    const std::string again =
        !by_hand ? ""
                 : fmt::format("  again: hydrabench work --store {} {}\n",
                               execution.store().root().string(), failure.job.string());
    text += fmt::format("{}: {}\n{}", failure.unit, failure.message, again);
    fmt::print(stderr, "{}\n{}", failure.unit, again);  // why was said when it happened
  }
  writeFileAtomic(folder / kFailuresFile, text);
}

std::string replaceableMarker(const std::filesystem::path& folder, bool replace) {
  return replace || std::filesystem::exists(folder / kFailuresFile) ? kResultMarker : "";
}

}  // namespace hydrabench

// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <sstream>
#include <thread>
#include <unistd.h>

#include <fmt/format.h>

#include "core/io/atomic_file.h"
#include "core/process/child_process.h"
#include "core/types/error.h"
#include "eval/experiment/executor.h"

namespace hydrabench {
namespace fs = std::filesystem;
namespace {

/// Clusters limit the size of an array; 1001 is Slurm's own default.
constexpr std::size_t kLargestArray = 1000;

struct Answer {
  bool ok = false;
  std::string out;
  std::string errors;
};

Answer ask(const std::vector<std::string>& command, const fs::path& errors) {
  std::error_code ignored;
  fs::remove(errors, ignored);
  Answer answer;
  ChildProcess process({.command = command, .error_file = errors});
  process.closeInput();
  while (const auto bytes = process.receive()) answer.out += *bytes;
  answer.ok = process.wait().ok();
  if (fs::exists(errors)) answer.errors = readFile(errors);
  return answer;
}

std::string quoted(const std::string& text) {
  std::string result = "'";
  for (const char c : text) result += c == '\'' ? "'\\''" : std::string(1, c);
  return result + "'";
}

std::string firstLine(const std::string& text) { return text.substr(0, text.find('\n')); }

/// What stands last in a log: the reason, if there is one.
std::string lastLine(const fs::path& log) {
  if (!fs::exists(log)) return "";
  std::istringstream lines(readFile(log));
  std::string last;
  for (std::string line; std::getline(lines, line);) {
    if (!line.empty()) last = line;
  }
  return last;
}

bool isDone(const Job& job, const UnitStore& store) {
  const auto done = [&](const auto& unit) { return store.isDone(unit.hash); };
  return std::all_of(job.runs.begin(), job.runs.end(), done) &&
         std::all_of(job.scores.begin(), job.scores.end(), done);
}

/// One array of the cluster.
class SlurmArray {
 public:
  SlurmArray(std::vector<Job> jobs, const UnitStore& store, const SlurmConfig& config,
             const ExecutorEvents& events)
      : jobs_(std::move(jobs)),
        store_(store),
        config_(config),
        events_(events),
        told_(jobs_.size(), false) {}

  void submit(const fs::path& folder) {
    folder_ = folder;
    for (std::size_t i = 0; i < jobs_.size(); ++i) {
      writeFileAtomic(folder_ / fmt::format("{}.json", i), jobJson(jobs_[i]));
    }
    const std::string program =
        config_.program.empty() ? fs::read_symlink("/proc/self/exe").string() : config_.program;
    const std::string threads =
        config_.threads > 0 ? std::to_string(config_.threads) : "${SLURM_CPUS_ON_NODE:-0}";
    writeFileAtomic(folder_ / "task.sh",
                    fmt::format("#!/bin/sh\nexec {} work --store {} --threads \"{}\" "
                                "{}/\"$SLURM_ARRAY_TASK_ID\".json\n",
                                quoted(program), quoted(fs::absolute(store_.root())), threads,
                                quoted(folder_)));
    std::vector<std::string> command = {"sbatch",
                                        "--parsable",
                                        fmt::format("--array=0-{}", jobs_.size() - 1),
                                        "--requeue",
                                        "--job-name=hydrabench",
                                        fmt::format("--output={}/%a.log", folder_.string()),
                                        "--open-mode=append"};
    for (const std::string& option : config_.sbatch) command.push_back("--" + option);
    command.push_back(folder_ / "task.sh");
    Answer answer;
    try {
      answer = ask(command, folder_ / "sbatch.log");
    } catch (const OutputError& error) {
      throw InputError(fmt::format("--executor slurm: {}", error.what()));
    }
    if (!answer.ok) {
      throw InputError(
          fmt::format("--executor slurm: sbatch refused: {}", firstLine(answer.errors)));
    }
    // "ID" or "ID;CLUSTER"
    id_ = firstLine(answer.out);
    id_ = id_.substr(0, id_.find(';'));
  }

  void wait() {
    while (true) {
      tellDone();
      const Answer queue =
          ask({"squeue", "--noheader", "--jobs=" + id_, "--format=%T"}, folder_ / "squeue.log");
      // Slurm forgets a job some time after its end; an answer that failed otherwise is asked
      // again.
      const bool forgotten = !queue.ok && queue.errors.find("Invalid job id") != std::string::npos;
      if (forgotten || (queue.ok && queue.out.empty())) break;
      std::this_thread::sleep_for(std::chrono::duration<double>(config_.poll_s));
    }
    // The last files may be on their way through a network file system.
    for (int i = 0; i < 5 && !allDone(); ++i) {
      std::this_thread::sleep_for(std::chrono::duration<double>(std::min(1.0, config_.poll_s)));
    }
    tellDone();
    for (std::size_t i = 0; i < jobs_.size(); ++i) {
      if (!told_[i]) lost(i);
    }
  }

 private:
  bool allDone() const {
    return std::all_of(jobs_.begin(), jobs_.end(),
                       [&](const Job& job) { return isDone(job, store_); });
  }

  void tellDone() {
    for (std::size_t i = 0; i < jobs_.size(); ++i) {
      if (told_[i] || !isDone(jobs_[i], store_)) continue;
      told_[i] = true;
      if (events_.on_job_done) events_.on_job_done(jobs_[i]);
    }
  }

  /// A task that has ended without having done its job.
  void lost(std::size_t task) {
    const Job& job = jobs_[task];
    const fs::path log = folder_ / fmt::format("{}.log", task);
    const auto tell = [&](const std::string& hash, const Job& unit) {
      std::optional<std::string> message = store_.failure(hash);
      if (!message) {
        const std::string last = lastLine(log);
        message = fmt::format("task {}_{} ended without it{} (log: {})", id_, task,
                              last.empty() ? "" : ": " + last, log.string());
        store_.recordFailure(hash, *message, unit);
      }
      if (events_.on_failure) events_.on_failure(unit.label(), *message);
    };
    for (const RunUnit& run : job.runs) {
      if (!store_.isDone(run.hash)) tell(run.hash, {job.world, {run}, {}});
    }
    for (const ScoreUnit& score : job.scores) {
      if (store_.isDone(score.run) && !store_.isDone(score.hash)) {
        tell(score.hash, {job.world, {}, {score}});
      }
    }
    told_[task] = true;
    if (events_.on_job_done) events_.on_job_done(job);
  }

  std::vector<Job> jobs_;
  const UnitStore& store_;
  const SlurmConfig& config_;
  const ExecutorEvents& events_;
  std::vector<char> told_;  ///< per task, whether its end was reported
  fs::path folder_;
  std::string id_;
};

}  // namespace

void executeOnSlurm(const std::vector<Job>& jobs, const UnitStore& store, const SlurmConfig& config,
                    const ExecutorEvents& events) {
  const auto now = std::chrono::system_clock::now().time_since_epoch();
  const auto stamp = std::chrono::duration_cast<std::chrono::milliseconds>(now).count();
  std::vector<SlurmArray> arrays;
  for (std::size_t begin = 0; begin < jobs.size(); begin += kLargestArray) {
    const std::size_t end = std::min(begin + kLargestArray, jobs.size());
    arrays.emplace_back(std::vector<Job>(jobs.begin() + static_cast<std::ptrdiff_t>(begin),
                                         jobs.begin() + static_cast<std::ptrdiff_t>(end)),
                        store, config, events);
    arrays.back().submit(fs::absolute(store.root()) / "jobs" /
                         fmt::format("slurm_{}_{}_{}", stamp, ::getpid(), begin));
  }
  for (SlurmArray& array : arrays) array.wait();
}

}  // namespace hydrabench

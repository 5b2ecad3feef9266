// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <deque>
#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>
#include <poll.h>
#include <thread>
#include <unistd.h>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "core/process/child_process.h"
#include "core/types/error.h"
#include "eval/experiment/executor.h"
#include "eval/experiment/instruction_counter.h"
#include "eval/experiment/job_runner.h"

namespace hydrabench {
namespace {

using Json = nlohmann::json;

/// One line of JSON, on its way at once.
void say(const Json& json) {
  std::cout << json.dump(-1, ' ', false, Json::error_handler_t::replace) << std::endl;
}

/// A job of one unit each: to find out which of them is at fault.
std::vector<Job> singleUnits(const Job& job, const UnitStore& store) {
  std::vector<Job> singles;
  for (const RunUnit& run : job.runs) {
    if (!store.isDone(run.hash)) singles.push_back({job.world, {run}, {}});
  }
  for (const ScoreUnit& score : job.scores) {
    if (store.isDone(score.hash)) continue;
    const auto own = std::find_if(singles.begin(), singles.end(), [&](const Job& single) {
      return !single.runs.empty() && single.runs.front().hash == score.run;
    });
    if (own != singles.end()) {
      own->scores.push_back(score);
    } else {
      singles.push_back({job.world, {}, {score}});
    }
  }
  return singles;
}

/// A folder for as long as this object lives.
struct ScratchFolder {
  explicit ScratchFolder(std::filesystem::path folder) : path(std::move(folder)) {
    std::filesystem::create_directories(path);
  }
  ~ScratchFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path, ignored);
  }
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;

  std::filesystem::path path;
};

class LocalExecutor {
 public:
  LocalExecutor(const std::vector<Job>& jobs, const UnitStore& store, const LocalConfig& config,
                const ExecutorEvents& events)
      : store_(store), config_(config), events_(events), waiting_(jobs.begin(), jobs.end()) {
    if (config.count_instructions) {
      scratch_.emplace(store.root() / fmt::format("counting_{}", ::getpid()));
    }
    workers_.resize(std::min(std::max<std::size_t>(1, config.jobs), jobs.size()));
  }

  void run() {
    while (true) {
      for (Worker& worker : workers_) {
        if (!worker.job && !waiting_.empty()) begin(worker);
      }
      if (!listen()) return;
    }
  }

 private:
  struct Worker {
    std::unique_ptr<ChildProcess> process;
    std::optional<Job> job;
    std::string said;  ///< the beginning of a line
  };

  void begin(Worker& worker) {
    if (!worker.process) worker.process = start();
    worker.job = std::move(waiting_.front());
    waiting_.pop_front();
    worker.process->send(Json::parse(jobJson(*worker.job)).dump() + "\n");
  }

  std::unique_ptr<ChildProcess> start() const {
    const auto cores = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
    // Threads that wait for each other spin: a number of instructions that is none of the work.
    const int threads = config_.count_instructions ? 1
                        : config_.threads > 0
                            ? config_.threads
                            : std::max(1, cores / static_cast<int>(workers_.size()));
    ChildProcess::Config config;
    if (scratch_) config.command = InstructionCounter::launcher(scratch_->path);
    // Behind a launcher, "/proc/self" would be the launcher's.
    const std::string program =
        scratch_ ? std::filesystem::canonical(config_.program).string() : config_.program;
    for (const std::string& argument :
         {program, std::string("work"), std::string("-"), std::string("--store"),
          store_.root().string(), fmt::format("--threads={}", threads)}) {
      config.command.push_back(argument);
    }
    config.memory_limit_mib = config_.memory_limit_mib;
    return std::make_unique<ChildProcess>(config);
  }

  /// Waits for a worker to say something. False when there is nothing left to wait for.
  bool listen() {
    std::vector<pollfd> handles;
    std::vector<std::size_t> indices;
    for (std::size_t i = 0; i < workers_.size(); ++i) {
      if (!workers_[i].job) continue;
      handles.push_back({workers_[i].process->outputHandle(), POLLIN, 0});
      indices.push_back(i);
    }
    if (handles.empty()) return false;
    if (::poll(handles.data(), handles.size(), -1) < 0) return true;  // a signal
    for (std::size_t i = 0; i < handles.size(); ++i) {
      if (handles[i].revents != 0) hear(indices[i]);
    }
    return true;
  }

  void hear(std::size_t index) {
    Worker& worker = workers_[index];
    const std::optional<std::string> bytes = worker.process->receive();
    if (!bytes) return lost(worker);
    worker.said += *bytes;
    std::size_t begin = 0;
    for (std::size_t end = 0; (end = worker.said.find('\n', begin)) != std::string::npos;
         begin = end + 1) {
      // What a library prints there is none of our lines.
      const Json line = Json::parse(worker.said.substr(begin, end - begin), nullptr, false);
      if (line.is_object()) understand(index, line);
    }
    worker.said.erase(0, begin);
  }

  void understand(std::size_t index, const Json& line) {
    Worker& worker = workers_[index];
    if (line.contains("frames")) {
      if (events_.on_world)
        events_.on_world(index, *worker.job, line.at("frames").get<std::size_t>());
    } else if (line.contains("frame")) {
      if (events_.on_frame) events_.on_frame(index, line.at("frame").get<std::size_t>());
    } else if (line.contains("failed")) {
      if (events_.on_failure) {
        events_.on_failure(line.at("failed").get<std::string>(),
                           line.at("message").get<std::string>());
      }
    } else if (line.contains("done")) {
      if (events_.on_job_done) events_.on_job_done(*worker.job);
      worker.job.reset();
    }
  }

  /// The process of a worker has ended in the middle of its job.
  void lost(Worker& worker) {
    const std::string how = worker.process->wait().text();
    worker.process.reset();
    worker.said.clear();
    const Job job = std::move(*worker.job);
    worker.job.reset();
    std::vector<Job> rest = singleUnits(job, store_);
    const bool was_single = job.runs.size() + (job.runs.empty() ? job.scores.size() : 0) == 1;
    const bool run_is_done = !job.runs.empty() && store_.isDone(job.runs.front().hash);
    if (!was_single || run_is_done) {
      waiting_.insert(waiting_.begin(), rest.begin(), rest.end());
      return;
    }
    for (const Job& single : rest) {
      const bool is_run = !single.runs.empty();
      const std::string message =
          config_.memory_limit_mib > 0
              ? fmt::format("{} (memory limit {} MiB)", how, config_.memory_limit_mib)
              : how;
      store_.recordFailure(is_run ? single.runs.front().hash : single.scores.front().hash, message,
                           single);
      if (events_.on_failure) events_.on_failure(single.label(), message);
    }
    if (events_.on_job_done) events_.on_job_done(job);
  }

  const UnitStore& store_;
  const LocalConfig& config_;
  const ExecutorEvents& events_;
  std::deque<Job> waiting_;
  std::optional<ScratchFolder> scratch_;  ///< where instructions are counted; outlives the workers
  std::vector<Worker> workers_;
};

}  // namespace

void workOnInput(UnitStore store) {
  JobRunner runner(std::move(store));
  std::size_t frame = 0;
  JobEvents events;
  events.on_world = [&](const WorldSpec&, std::size_t frames) {
    frame = 0;
    say({{"frames", frames}});
  };
  events.on_frame = [&] {
    if (++frame % 10 == 0) say({{"frame", frame}});
  };
  events.on_failure = [](const std::string& unit, const std::string& message) {
    say({{"failed", unit}, {"message", message}});
  };
  for (std::string line; std::getline(std::cin, line);) {
    runner.run(jobFromJson(line, "standard input"), events);
    say({{"done", true}});
  }
}

void executeLocally(const std::vector<Job>& jobs, const UnitStore& store, const LocalConfig& config,
                    const ExecutorEvents& events) {
  LocalExecutor(jobs, store, config, events).run();
}

}  // namespace hydrabench

// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "eval/experiment/executor.h"
#include "tests/support/temporary_folder.h"

namespace hydrabench {
namespace {

using ::testing::ElementsAre;
using ::testing::SizeIs;

/// A worker in a few lines: a run is done once its folder is in the store. It dies where a job asks
/// for a run whose hash begins with "bad", and notes every job it is given.
constexpr const char* kWorker = R"(#!/bin/bash
store=$4
while read -r line; do
  echo job >> "$store/../jobs.txt"
  hashes=$(grep -o '"hash":"[a-z0-9]*"' <<< "$line" | cut -d'"' -f4)
  for hash in $hashes; do
    case $hash in bad*) kill -9 $$ ;; esac
    mkdir -p "$store/runs/${hash:0:2}/$hash"
  done
  echo '{"frames": 20}'
  echo '{"frame": 10}'
  echo '{"done": true}'
done
)";

class LocalExecution : public ::testing::Test {
 protected:
  LocalExecution() : store_(folder_ / "store") {
    writeText(folder_ / "worker", kWorker);
    std::filesystem::permissions(folder_ / "worker", std::filesystem::perms::owner_all);
    std::filesystem::create_directories(store_.root());
    config_.program = folder_ / "worker";
    events_.on_failure = [this](const std::string& unit, const std::string& message) {
      failures_.push_back(unit + ": " + message);
    };
    events_.on_job_done = [this](const Job&) { ++jobs_done_; };
    events_.on_frame = [this](std::size_t, std::size_t frame) {
      EXPECT_EQ(frame, 10u);
      ++frames_;
    };
  }

  Job job(const std::vector<std::string>& hashes) {
    Job job;
    job.world.dataset = "toy";
    for (const std::string& hash : hashes) job.runs.push_back({hash, {hash}, "type: toy"});
    return job;
  }
  void execute(const std::vector<Job>& jobs) { executeLocally(jobs, store_, config_, events_); }
  std::string state(const std::string& hash) {
    const UnitStore::State state = store_.state(hash);
    return state == UnitStore::State::kDone     ? "done"
           : state == UnitStore::State::kFailed ? "failed"
                                                : "missing";
  }

  TemporaryFolder folder_;
  UnitStore store_;
  LocalConfig config_;
  ExecutorEvents events_;
  std::vector<std::string> failures_;
  int jobs_done_ = 0;
  int frames_ = 0;
};

TEST_F(LocalExecution, DoesEveryJobInAsManyProcessesAsAskedFor) {
  config_.jobs = 3;
  execute({job({"a1"}), job({"a2", "a3"}), job({"a4"}), job({"a5"}), job({"a6"})});
  for (const char* hash : {"a1", "a2", "a3", "a4", "a5", "a6"}) EXPECT_EQ(state(hash), "done");
  EXPECT_EQ(jobs_done_, 5);
  EXPECT_EQ(frames_, 5);
  EXPECT_THAT(failures_, SizeIs(0));
}

TEST_F(LocalExecution, ACrashTakesOnlyTheUnitThatCausedIt) {
  config_.jobs = 2;
  execute({job({"a1", "bad1", "a2"}), job({"a3"})});
  EXPECT_EQ(state("a1"), "done");
  EXPECT_EQ(state("a2"), "done");
  EXPECT_EQ(state("a3"), "done");
  EXPECT_EQ(state("bad1"), "failed");
  EXPECT_THAT(failures_, ElementsAre("toy, seed 0: bad1: killed by signal 9 (Killed)"));
  EXPECT_EQ(store_.failure("bad1"), "killed by signal 9 (Killed)");
}

TEST_F(LocalExecution, WhatWasDoneBeforeTheCrashIsNotDoneAgain) {
  execute({job({"a1", "a2", "bad1"})});
  // The job, then bad1 alone: a1 and a2 were there when it died.
  EXPECT_EQ(readText(folder_ / "jobs.txt"), "job\njob\n");
}

TEST_F(LocalExecution, NamesTheMemoryLimitThatMayHaveBeenTheReason) {
  config_.memory_limit_mib = 4096;
  execute({job({"bad1"})});
  EXPECT_THAT(failures_, ElementsAre("toy, seed 0: bad1: killed by signal 9 (Killed) (memory limit "
                                     "4096 MiB)"));
}

TEST_F(LocalExecution, NothingToDoIsDoneAtOnce) {
  execute({});
  EXPECT_EQ(jobs_done_, 0);
}

}  // namespace
}  // namespace hydrabench

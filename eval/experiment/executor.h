// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "eval/experiment/job.h"
#include "eval/experiment/unit_store.h"

namespace hydrabench {

/// What is to be told while jobs are carried out somewhere else.
struct ExecutorEvents {
  /// Worker `worker` has opened the world of a job and makes `frames` frames of it.
  std::function<void(std::size_t worker, const Job&, std::size_t frames)> on_world;
  std::function<void(std::size_t worker, std::size_t frame)> on_frame;  ///< so many are done
  std::function<void(const Job&)> on_job_done;  ///< with or without failures
  std::function<void(const std::string& unit, const std::string& message)> on_failure;
};

/// Says to its caller, a line of JSON each on standard output, how far a job is: what `hydrabench
/// work -` does with every line of JSON that it reads.
void workOnInput(UnitStore store);

struct LocalConfig {
  std::size_t jobs = 1;                ///< processes
  int threads = 0;                     ///< of each; 0: all cores shared out
  std::uint64_t memory_limit_mib = 0;  ///< of each; 0: none
  bool count_instructions = false;     ///< of every frame, by an InstructionCounter
  std::string program = "/proc/self/exe";
};
/// In processes on this machine, each with one job after another. A process that dies (a crash, the
/// memory limit) takes the units of its job with it; each of them is tried once more by itself, and
/// the one that was at fault is recorded as failed.
void executeLocally(const std::vector<Job>& jobs, const UnitStore& store, const LocalConfig& config,
                    const ExecutorEvents& events);

struct SlurmConfig {
  std::vector<std::string> sbatch;  ///< key=value, passed on as --key=value
  int threads = 0;                  ///< of each task; 0: those that Slurm gives it
  double poll_s = 2;
  std::string program;  ///< path of hydrabench on the nodes; empty: ours
};
/// As a job array of a Slurm cluster, through sbatch and squeue, and waits for it. Store and
/// program lie where every node sees them. A task that Slurm kills and puts into the queue again
/// goes on where it was. Throws InputError where sbatch refuses.
void executeOnSlurm(const std::vector<Job>& jobs, const UnitStore& store, const SlurmConfig& config,
                    const ExecutorEvents& events);

}  // namespace hydrabench

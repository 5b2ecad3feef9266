// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <utility>

#include "eval/experiment/job.h"

namespace hydrabench {

/// A folder of finished work, addressed by content hash; several programs and machines may share
/// it. What stands in it is complete: a unit appears under its name in one step.
///
///     runs/ab/abcd…/        prediction, candidates, timing.csv, config.yaml, run.json
///     scores/ab/abcd….json  evaluation_io.h
///     failures/abcd….json   message and job of what failed last time
///     locks/abcd…           held while somebody works on it
///     jobs/                 of executors
class UnitStore {
 public:
  explicit UnitStore(std::filesystem::path root) : root_(std::move(root)) {}

  const std::filesystem::path& root() const { return root_; }
  std::filesystem::path runFolder(const std::string& hash) const;
  std::filesystem::path scoreFile(const std::string& hash) const;
  std::filesystem::path failureFile(const std::string& hash) const;

  enum class State { kDone, kRunning, kFailed, kMissing };
  /// Of a run or of a score.
  State state(const std::string& hash) const;
  bool isDone(const std::string& hash) const;
  /// Throws OutputError where nothing can be written: to be known before the work.
  void requireWritable() const;

  /// Held until destroyed or until the process ends, however it ends.
  class Lock {
   public:
    explicit Lock(const std::filesystem::path& file);  ///< waits for others
    ~Lock();
    Lock(Lock&& other) noexcept : handle_(std::exchange(other.handle_, -1)) {}
    Lock& operator=(Lock&&) = delete;

   private:
    int handle_;
  };
  Lock lock(const std::string& hash) const;

  /// @param job  what to do again for this unit alone
  void recordFailure(const std::string& hash, const std::string& message, const Job& job) const;
  void clearFailure(const std::string& hash) const;
  /// The message of the last failure; nullopt without one.
  std::optional<std::string> failure(const std::string& hash) const;

 private:
  std::filesystem::path lockFile(const std::string& hash) const;

  std::filesystem::path root_;
};

/// --store, else the environment variable HYDRABENCH_STORE, else .hydrabench/store here.
std::filesystem::path storeFolder(const std::filesystem::path& option);

}  // namespace hydrabench

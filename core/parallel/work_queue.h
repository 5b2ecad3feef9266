// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <exception>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <set>
#include <thread>
#include <utility>
#include <vector>

namespace hydrabench {

/// Threads that take jobs in order of submission. The part of WorkQueue without a type.
class WorkerThreads {
 public:
  /// @param num_threads  0: submit() does the job itself
  /// @param capacity     jobs that may wait for a thread, at least 1
  WorkerThreads(int num_threads, std::size_t capacity);
  /// Jobs that have not begun are dropped; those that have are waited for.
  ~WorkerThreads();
  WorkerThreads(const WorkerThreads&) = delete;
  WorkerThreads& operator=(const WorkerThreads&) = delete;

  /// Blocks while `capacity` jobs wait. The job must not throw. Jobs are numbered from 0.
  void submit(std::function<void()> job);
  bool isDone(std::uint64_t number) const;
  void wait(std::uint64_t number) const;  ///< for a job that was submitted

 private:
  void work();

  const std::size_t capacity_;
  mutable std::mutex mutex_;
  std::condition_variable job_waits_;
  std::condition_variable slot_is_free_;
  mutable std::condition_variable job_is_done_;
  std::deque<std::pair<std::uint64_t, std::function<void()>>> waiting_;
  std::set<std::uint64_t> unfinished_;  ///< waiting or running
  std::uint64_t num_submitted_ = 0;
  bool closing_ = false;
  std::vector<std::thread> threads_;
};

/// Work off the calling thread, with results in order of submission whatever the timing. One thread
/// submits and takes; submit() blocks while too many jobs wait, so that memory stays bounded.
template <typename Result>
class WorkQueue {
 public:
  WorkQueue(int num_threads, std::size_t capacity) : threads_(num_threads, capacity) {}

  void submit(std::function<Result()> job) {
    auto slot = std::make_shared<Slot>();
    slots_.push_back(slot);
    threads_.submit([slot = std::move(slot), job = std::move(job)] {
      try {
        slot->result.emplace(job());
      } catch (...) {
        slot->error = std::current_exception();
      }
    });
  }
  /// Jobs whose results were not taken yet.
  std::size_t size() const { return slots_.size(); }
  /// Whether take() would return at once.
  bool ready() const { return !slots_.empty() && threads_.isDone(num_taken_); }
  /// Result of the oldest job that is left; waits for it. What the job threw is thrown here.
  Result take() {
    threads_.wait(num_taken_);
    const std::shared_ptr<Slot> slot = std::move(slots_.front());
    slots_.pop_front();
    ++num_taken_;
    if (slot->error) std::rethrow_exception(slot->error);
    return std::move(*slot->result);
  }

 private:
  struct Slot {
    std::optional<Result> result;
    std::exception_ptr error;
  };
  std::deque<std::shared_ptr<Slot>> slots_;
  std::uint64_t num_taken_ = 0;
  WorkerThreads threads_;  ///< last: it ends before the rest goes
};

}  // namespace hydrabench

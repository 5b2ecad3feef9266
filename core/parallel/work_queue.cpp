// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "core/parallel/work_queue.h"

#include <cassert>

namespace hydrabench {

WorkerThreads::WorkerThreads(int num_threads, std::size_t capacity) : capacity_(capacity) {
  assert(num_threads >= 0 && capacity >= 1);
  for (int i = 0; i < num_threads; ++i) threads_.emplace_back([this] { work(); });
}

WorkerThreads::~WorkerThreads() {
  {
    const std::lock_guard lock(mutex_);
    closing_ = true;
    waiting_.clear();
  }
  job_waits_.notify_all();
  for (std::thread& thread : threads_) thread.join();
}

void WorkerThreads::submit(std::function<void()> job) {
  if (threads_.empty()) {
    job();
    const std::lock_guard lock(mutex_);
    ++num_submitted_;
    return;
  }
  {
    std::unique_lock lock(mutex_);
    slot_is_free_.wait(lock, [&] { return waiting_.size() < capacity_; });
    unfinished_.insert(num_submitted_);
    waiting_.emplace_back(num_submitted_++, std::move(job));
  }
  job_waits_.notify_one();
}

bool WorkerThreads::isDone(std::uint64_t number) const {
  const std::lock_guard lock(mutex_);
  return number < num_submitted_ && !unfinished_.contains(number);
}

void WorkerThreads::wait(std::uint64_t number) const {
  std::unique_lock lock(mutex_);
  assert(number < num_submitted_);
  job_is_done_.wait(lock, [&] { return !unfinished_.contains(number); });
}

void WorkerThreads::work() {
  while (true) {
    std::uint64_t number = 0;
    {
      std::unique_lock lock(mutex_);
      job_waits_.wait(lock, [&] { return closing_ || !waiting_.empty(); });
      if (closing_) return;
      number = waiting_.front().first;
      std::function<void()> job = std::move(waiting_.front().second);
      waiting_.pop_front();
      lock.unlock();
      slot_is_free_.notify_one();
      job();
      job = nullptr;  // what it holds goes before it counts as done
    }
    {
      const std::lock_guard lock(mutex_);
      unfinished_.erase(number);
    }
    job_is_done_.notify_all();
  }
}

}  // namespace hydrabench

// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "core/parallel/parallel_for.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <limits>
#include <mutex>

#include "core/parallel/tbb_pool.h"

namespace hydrabench {
namespace {

/// One loop. The two counters tell a thread sanitizer what it cannot see in TBB: that starting a
/// task and waiting for it order memory.
class Loop {
 public:
  Loop(std::size_t count, std::size_t grain,
       const std::function<void(std::size_t, std::size_t)>& body)
      : count_(count), grain_(grain), body_(body) {}

  void run() {
    const std::size_t num_ranges = (count_ - 1) / grain_ + 1;
    started_.store(true, std::memory_order_release);
    runOnPool(
        num_ranges,
        [](void* loop, std::size_t range) { static_cast<Loop*>(loop)->runRange(range); }, this);
    num_done_.load(std::memory_order_acquire);
    if (error_) std::rethrow_exception(error_);
  }

 private:
  void runRange(std::size_t range) {
    started_.load(std::memory_order_acquire);
    const std::size_t begin = range * grain_;
    try {
      body_(begin, std::min(count_, begin + grain_));
    } catch (...) {
      keepFirst(begin);
    }
    num_done_.fetch_add(1, std::memory_order_release);
  }

  /// Of several errors the one with the lowest index, so that which one is reported does not depend
  /// on timing.
  void keepFirst(std::size_t begin) {
    const std::lock_guard lock(mutex_);
    if (begin > error_begin_) return;
    error_ = std::current_exception();
    error_begin_ = begin;
  }

  const std::size_t count_;
  const std::size_t grain_;
  const std::function<void(std::size_t, std::size_t)>& body_;
  std::atomic<bool> started_ = false;
  std::atomic<std::size_t> num_done_ = 0;
  std::mutex mutex_;
  std::exception_ptr error_;
  std::size_t error_begin_ = std::numeric_limits<std::size_t>::max();
};

}  // namespace

void setNumThreads(int num_threads) { setPoolSize(num_threads); }

int numThreads() { return poolSize(); }

void parallelForRanges(std::size_t count, std::size_t grain,
                       const std::function<void(std::size_t, std::size_t)>& body) {
  if (count == 0) return;
  Loop(count, std::max<std::size_t>(1, grain), body).run();
}

void parallelFor(std::size_t count, const std::function<void(std::size_t)>& body,
                 std::size_t grain) {
  parallelForRanges(count, grain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) body(i);
  });
}

void runOnThisThreadOnly(const std::function<void()>& body) {
  // Kept here on the way through the arena, so that it leaves as it was thrown.
  struct Call {
    const std::function<void()>& body;
    std::exception_ptr error;
  } call{body, nullptr};
  runAlone(
      [](void* context) {
        Call& self = *static_cast<Call*>(context);
        try {
          self.body();
        } catch (...) {
          self.error = std::current_exception();
        }
      },
      &call);
  if (call.error) std::rethrow_exception(call.error);
}

}  // namespace hydrabench

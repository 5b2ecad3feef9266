// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "core/parallel/parallel_for.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <memory>
#include <mutex>

#include <tbb/blocked_range.h>
#include <tbb/global_control.h>
#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

namespace hydrabench {
namespace {

std::mutex g_mutex;
int g_num_threads = 0;
std::unique_ptr<tbb::global_control> g_limit;

/// Keeps the exception of the lowest index, so that which error is reported does not depend on
/// timing.
class FirstError {
 public:
  void capture(std::size_t index) {
    const std::lock_guard lock(mutex_);
    if (!error_ || index < index_) {
      error_ = std::current_exception();
      index_ = index;
    }
  }
  void rethrow() const {
    if (error_) std::rethrow_exception(error_);
  }

 private:
  std::mutex mutex_;
  std::exception_ptr error_;
  std::size_t index_ = 0;
};

}  // namespace

void setNumThreads(int num_threads) {
  const std::lock_guard lock(g_mutex);
  g_num_threads = std::max(0, num_threads);
  g_limit.reset();
  if (g_num_threads > 0) {
    g_limit = std::make_unique<tbb::global_control>(tbb::global_control::max_allowed_parallelism,
                                                    static_cast<std::size_t>(g_num_threads));
  }
}

int numThreads() {
  const std::lock_guard lock(g_mutex);
  return g_num_threads > 0 ? g_num_threads : tbb::info::default_concurrency();
}

void parallelForRanges(std::size_t count, std::size_t grain,
                       const std::function<void(std::size_t, std::size_t)>& body) {
  if (count == 0) return;
  grain = std::max<std::size_t>(1, grain);
  const std::size_t num_ranges = (count + grain - 1) / grain;
  FirstError first_error;
  const auto run = [&](std::size_t range) {
    const std::size_t begin = range * grain;
    try {
      body(begin, std::min(count, begin + grain));
    } catch (...) {
      first_error.capture(begin);
    }
  };
  if (num_ranges == 1 || numThreads() == 1) {
    for (std::size_t range = 0; range < num_ranges; ++range) run(range);
  } else {
    tbb::parallel_for(std::size_t{0}, num_ranges, run);
  }
  first_error.rethrow();
}

void parallelFor(std::size_t count, const std::function<void(std::size_t)>& body,
                 std::size_t grain) {
  parallelForRanges(count, grain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) body(i);
  });
}

}  // namespace hydrabench

// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "core/parallel/tbb_pool.h"

#include <memory>
#include <mutex>

#include <tbb/global_control.h>
#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

namespace hydrabench {
namespace {

/// The arena offers the slots, the limit lets TBB start more threads than there are cores.
struct Pool {
  explicit Pool(int num_threads)
      : size(num_threads),
        limit(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(num_threads)),
        arena(num_threads) {}
  int size;
  tbb::global_control limit;
  tbb::task_arena arena;
};

std::mutex g_mutex;
std::shared_ptr<Pool> g_pool;

std::shared_ptr<Pool> pool() {
  const std::lock_guard lock(g_mutex);
  if (!g_pool) g_pool = std::make_shared<Pool>(tbb::info::default_concurrency());
  return g_pool;
}

}  // namespace

void setPoolSize(int num_threads) {
  const int size = num_threads > 0 ? num_threads : tbb::info::default_concurrency();
  const std::lock_guard lock(g_mutex);
  if (g_pool && g_pool->size == size) return;
  g_pool.reset();  // first: of two limits alive TBB takes the smaller
  g_pool = std::make_shared<Pool>(size);
}

int poolSize() { return pool()->size; }

void runOnPool(std::size_t count, void (*task)(void*, std::size_t), void* context) {
  const std::shared_ptr<Pool> threads = pool();
  if (count == 1 || threads->size == 1) {
    for (std::size_t i = 0; i < count; ++i) task(context, i);
    return;
  }
  threads->arena.execute([&] {
    // Isolated: a thread that waits for an inner loop must not pick up another iteration of an
    // outer one meanwhile, it would see thread-local state or a lock half-way through.
    tbb::this_task_arena::isolate([&] {
      tbb::parallel_for(std::size_t{0}, count, [=](std::size_t i) { task(context, i); });
    });
  });
}

void runAlone(void (*task)(void*), void* context) {
  tbb::task_arena arena(1);
  arena.execute([&] { task(context); });
}

}  // namespace hydrabench

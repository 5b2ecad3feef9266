// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

namespace hydrabench {

/// The threads of the process, by oneTBB. For parallel_for.cpp only: TBB is not instrumented, so
/// its half stands in a file of its own that no thread sanitizer looks at, and parallel_for.cpp
/// states the order of memory around every task.

void setPoolSize(int num_threads);  ///< 0: all cores
int poolSize();

/// Calls task(context, i) for every i below count, on the threads of the pool; returns when all
/// calls have.
void runOnPool(std::size_t count, void (*task)(void*, std::size_t), void* context);

/// Calls task(context) on this thread, with no other thread to help TBB loops inside it.
void runAlone(void (*task)(void*), void* context);

}  // namespace hydrabench

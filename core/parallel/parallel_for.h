// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <functional>
#include <type_traits>
#include <vector>

namespace hydrabench {

/// Sets how many threads parallelFor may use, process-wide. 0: all cores. Not while a loop runs.
void setNumThreads(int num_threads);
int numThreads();

/// Calls body(i) for every i in [0, count), on several threads. The calls must not depend on each
/// other: then the result is the same for any number of threads. Every call is made even if one
/// throws; of several exceptions the one with the lowest index leaves through the caller. Loops may
/// be nested.
/// @param grain  indices handed to a thread at a time; above 1 where body is short
void parallelFor(std::size_t count, const std::function<void(std::size_t)>& body,
                 std::size_t grain = 1);

/// Calls body(begin, end) over consecutive ranges of `grain` indices. The ranges depend on count
/// and grain only.
void parallelForRanges(std::size_t count, std::size_t grain,
                       const std::function<void(std::size_t, std::size_t)>& body);

/// Sum (or any fold) whose order of combination is fixed: map(i) runs in parallel,
/// combine(accumulator, value) in index order.
template <typename Value, typename Map, typename Combine>
Value parallelReduce(std::size_t count, Value accumulator, const Map& map, const Combine& combine) {
  using Mapped = std::decay_t<std::invoke_result_t<const Map&, std::size_t>>;
  static_assert(!std::is_same_v<Mapped, bool>, "bits of a vector<bool> share bytes: map to char");
  std::vector<Mapped> values(count);
  parallelFor(count, [&](std::size_t i) { values[i] = map(i); });
  for (Mapped& value : values) combine(accumulator, value);
  return accumulator;
}

/// Calls body() such that a library inside that spreads its work with oneTBB (Embree) stays on this
/// thread: for work whose result would depend on how it is split.
void runOnThisThreadOnly(const std::function<void()>& body);

}  // namespace hydrabench

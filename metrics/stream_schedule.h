// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <limits>
#include <span>
#include <vector>

namespace hydrabench {

/// A shape that a mapper asks its estimator for.
struct StreamRequest {
  double arrival_s = 0;  ///< when it is asked for, from the start of the sequence
  double latency_s = 0;  ///< how long the estimator works on it, >= 0
  double due_s = std::numeric_limits<double>::infinity();  ///< by when it should be there
};

struct StreamCompletion {
  double start_s = 0;  ///< >= arrival
  double end_s = 0;    ///< start + latency
  bool late = false;   ///< ended after it was due
};

/// First come, first served by `servers` estimators side by side; of requests that come at the same
/// time the one listed first. Nothing is dropped: a late shape is better than none.
/// @return  per request
std::vector<StreamCompletion> schedule(std::span<const StreamRequest> requests, int servers);

/// A value that changes in steps: holds from `time_s` on, up to the next.
struct StreamStep {
  double time_s = 0;
  double value = 0;
};

/// Requests that have come and were not begun, over time; the first step is at 0.
std::vector<StreamStep> queueLength(std::span<const StreamRequest> requests,
                                    std::span<const StreamCompletion> completions);

/// Mean over [0, duration_s] of a value that is 0 before its first step. What comes later does not
/// count. `steps` in order of time.
double meanOverTime(std::span<const StreamStep> steps, double duration_s);

}  // namespace hydrabench

// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "metrics/stream_schedule.h"

#include <algorithm>
#include <cassert>
#include <functional>
#include <map>
#include <numeric>
#include <queue>

namespace hydrabench {

std::vector<StreamCompletion> schedule(std::span<const StreamRequest> requests, int servers) {
  assert(servers > 0);
  std::vector<std::size_t> order(requests.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return requests[a].arrival_s < requests[b].arrival_s;
  });
  std::priority_queue<double, std::vector<double>, std::greater<>> free_at;
  for (int i = 0; i < servers; ++i) free_at.push(0);
  std::vector<StreamCompletion> completions(requests.size());
  for (const std::size_t i : order) {
    StreamCompletion& completion = completions[i];
    completion.start_s = std::max(requests[i].arrival_s, free_at.top());
    completion.end_s = completion.start_s + requests[i].latency_s;
    completion.late = completion.end_s > requests[i].due_s;
    free_at.pop();
    free_at.push(completion.end_s);
  }
  return completions;
}

std::vector<StreamStep> queueLength(std::span<const StreamRequest> requests,
                                    std::span<const StreamCompletion> completions) {
  assert(requests.size() == completions.size());
  std::map<double, int> changes = {{0.0, 0}};
  for (std::size_t i = 0; i < requests.size(); ++i) {
    ++changes[requests[i].arrival_s];
    --changes[completions[i].start_s];
  }
  std::vector<StreamStep> steps;
  int waiting = 0;
  for (const auto& [time_s, change] : changes) {
    if (change == 0 && !steps.empty()) continue;  // begun as soon as it came
    waiting += change;
    steps.push_back({time_s, static_cast<double>(waiting)});
  }
  return steps;
}

double meanOverTime(std::span<const StreamStep> steps, double duration_s) {
  assert(duration_s > 0);
  double area = 0;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const double begin = std::clamp(steps[i].time_s, 0.0, duration_s);
    const double end =
        i + 1 < steps.size() ? std::clamp(steps[i + 1].time_s, 0.0, duration_s) : duration_s;
    area += steps[i].value * (end - begin);
  }
  return area / duration_s;
}

}  // namespace hydrabench

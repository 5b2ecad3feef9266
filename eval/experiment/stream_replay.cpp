// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/experiment/stream_replay.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numeric>
#include <utility>

#include "core/types/random.h"

namespace hydrabench {
namespace {

constexpr const char* kNotReady = "not ready";
/// Latencies of this many recordings are as good as endless.
constexpr double kEndless = 1e6;

double seconds(std::int64_t ns) { return static_cast<double>(ns) / 1e9; }

/// What a decision looks at; of hundreds of copies nothing else should be made.
ShapeCandidate withoutSurfaces(ShapeCandidate candidate) {
  candidate.mesh = {};
  candidate.mask = {};
  if (!candidate.partial_mesh.empty()) {
    candidate.partial_mesh = boxMesh(bounds(candidate.partial_mesh));
  }
  return candidate;
}

/// A request that was not answered yet leaves neither a shape nor what was seen.
ShapeCandidate notReady(ShapeCandidate candidate) {
  candidate.failure = kNotReady;
  candidate.partial_mesh = {};
  return candidate;
}

double durationOf(const StreamWorld& world, const StreamConfig& config) {
  return seconds(world.end_ns - world.start_ns) + config.after_s;
}

double valueAt(const std::vector<StreamStep>& steps, double time_s) {
  double value = 0;
  for (const StreamStep& step : steps) {
    if (step.time_s > time_s) break;
    value = step.value;
  }
  return value;
}

/// Mean of several step functions.
std::vector<StreamStep> meanOf(const std::vector<std::vector<StreamStep>>& functions) {
  std::vector<std::pair<double, double>> changes;  // time, by how much
  for (const std::vector<StreamStep>& steps : functions) {
    double before = 0;
    for (const StreamStep& step : steps) {
      changes.emplace_back(step.time_s, step.value - before);
      before = step.value;
    }
  }
  std::stable_sort(changes.begin(), changes.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<StreamStep> mean;
  double sum = 0;
  for (const auto& [time_s, change] : changes) {
    sum += change;
    const double value = sum / static_cast<double>(functions.size());
    if (!mean.empty() && mean.back().time_s == time_s) {
      mean.back().value = value;
    } else {
      mean.push_back({time_s, value});
    }
  }
  return mean;
}

}  // namespace

std::size_t StreamOutcome::misses() const {
  return static_cast<std::size_t>(
      std::count_if(shapes.begin(), shapes.end(),
                    [](const StreamedShape& shape) { return shape.completion.late; }));
}

double StreamOutcome::meanLatency() const {
  if (shapes.empty()) return 0;
  const double sum = std::accumulate(
      shapes.begin(), shapes.end(), 0.0,
      [](double s, const StreamedShape& shape) { return s + shape.request.latency_s; });
  return sum / static_cast<double>(shapes.size());
}

double StreamOutcome::lastReady() const {
  double last = 0;
  for (const StreamedShape& shape : shapes) last = std::max(last, shape.completion.end_s);
  return last;
}

StreamReplay::StreamReplay(std::vector<StreamWorld> worlds, const EvaluationConfig& config)
    : worlds_(std::move(worlds)), counted_(worlds_.size()) {
  assert(!worlds_.empty());
  for (StreamWorld& world : worlds_) {
    geometry_.emplace_back(world.candidates);
    for (ShapeCandidate& candidate : world.candidates) {
      candidate = withoutSurfaces(std::move(candidate));
    }
  }
  for (const double threshold : config.thresholds_m) {
    for (const Matching matching : {Matching::kExists, Matching::kOneToOne}) {
      scored_.push_back({.threshold = Threshold::tau(threshold), .matching = matching});
    }
  }
}

const StreamReplay::Counts& StreamReplay::countsOf(std::size_t world,
                                                   const std::vector<bool>& ready) const {
  const auto [found, is_new] = counted_[world].try_emplace(ready);
  if (!is_new) return found->second;
  const StreamWorld& of = worlds_[world];
  std::vector<ShapeCandidate> candidates = of.candidates;
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    if (!ready[i]) candidates[i] = notReady(std::move(candidates[i]));
  }
  const std::vector<DetectionObject> estimates =
      geometry_[world].estimates(decide(candidates, of.decision), of.counting);
  for (const StreamScore& score : scored_) {
    found->second.push_back(
        counts(match(score.matching, estimates, of.counting.truths, score.threshold)));
  }
  return found->second;
}

std::vector<StreamedShape> StreamReplay::schedule(const StreamWorld& world,
                                                  const std::optional<LatencyModel>& latency,
                                                  const StreamConfig& config, double factor) const {
  assert(latency || world.measured);
  const LatencyModel& model = latency ? *latency : *world.measured;
  std::vector<StreamRequest> requests;
  std::vector<StreamedShape> shapes;
  for (const ShapeCandidate& candidate : world.candidates) {
    StreamedShape& shape = shapes.emplace_back();
    shape.seed = world.seed;
    shape.track = candidate.track;
    shape.last_seen_s = seconds(candidate.last_observed_ns - world.start_ns);
    StreamRequest& request = shape.request;
    // At the end of a run all tracks end.
    request.arrival_s =
        std::min(shape.last_seen_s + world.request_after_s, seconds(world.end_ns - world.start_ns));
    // By the track alone: with another model, a share stays the share it was.
    Random random(hashSeed(config.seed, world.seed), candidate.track);
    request.latency_s = factor * model.quantile_s(random.uniform());
    request.due_s = (config.deadline_from_last_seen ? shape.last_seen_s : request.arrival_s) +
                    config.deadline_s;
    requests.push_back(request);
  }
  const std::vector<StreamCompletion> done = hydrabench::schedule(requests, config.servers);
  for (std::size_t i = 0; i < shapes.size(); ++i) shapes[i].completion = done[i];
  return shapes;
}

StreamOutcome StreamReplay::run(const std::optional<LatencyModel>& latency,
                                const StreamConfig& config, double factor) const {
  StreamOutcome outcome;
  struct Event {
    double time_s;
    std::size_t world;
    std::size_t candidate;
  };
  std::vector<Event> events;
  std::vector<std::vector<StreamStep>> queues;
  for (std::size_t w = 0; w < worlds_.size(); ++w) {
    const std::vector<StreamedShape> shapes = schedule(worlds_[w], latency, config, factor);
    std::vector<StreamRequest> requests;
    std::vector<StreamCompletion> completions;
    for (std::size_t i = 0; i < shapes.size(); ++i) {
      events.push_back({shapes[i].completion.end_s, w, i});
      requests.push_back(shapes[i].request);
      completions.push_back(shapes[i].completion);
    }
    queues.push_back(queueLength(requests, completions));
    for (const StreamStep& step : queues.back()) {
      outcome.longest_queue = std::max(outcome.longest_queue, step.value);
    }
    outcome.shapes.insert(outcome.shapes.end(), shapes.begin(), shapes.end());
    outcome.duration_s = std::max(outcome.duration_s, durationOf(worlds_[w], config));
  }
  std::stable_sort(events.begin(), events.end(),
                   [](const Event& a, const Event& b) { return a.time_s < b.time_s; });
  outcome.queue = meanOf(queues);
  outcome.mean_queue = meanOverTime(outcome.queue, outcome.duration_s);

  outcome.scores = scored_;
  std::vector<std::vector<bool>> ready;
  for (const StreamWorld& world : worlds_) ready.emplace_back(world.candidates.size(), false);
  for (std::size_t e = 0; e < events.size(); ++e) {
    ready[events[e].world][events[e].candidate] = true;
    if (e + 1 < events.size() && events[e + 1].time_s == events[e].time_s) continue;
    Counts sum(scored_.size());
    for (std::size_t w = 0; w < worlds_.size(); ++w) {
      const Counts& of_world = countsOf(w, ready[w]);
      for (std::size_t k = 0; k < sum.size(); ++k) sum[k] += of_world[k];
    }
    for (std::size_t k = 0; k < sum.size(); ++k) {
      outcome.scores[k].f1.push_back({events[e].time_s, f1(sum[k]).value_or(0)});
    }
  }
  for (StreamScore& score : outcome.scores) {
    score.area = meanOverTime(score.f1, outcome.duration_s);
    score.f1_at_end = valueAt(score.f1, outcome.duration_s);
    score.f1_of_all = score.f1.empty() ? 0 : score.f1.back().value;
  }
  return outcome;
}

std::optional<BreakEven> breakEven(const StreamReplay& slower,
                                   const std::optional<LatencyModel>& latency,
                                   const StreamConfig& config, std::size_t k, double area) {
  const auto areaAt = [&](double factor) {
    return slower.run(latency, config, factor).scores[k].area;
  };
  const StreamOutcome own = slower.run(latency, config);
  const double mean_s = own.meanLatency();
  if (!(areaAt(0) > area) || mean_s == 0) return std::nullopt;
  double pays = 0;
  double fails = 1e-3 / mean_s;  // a millisecond, doubled until it is too much
  while (areaAt(fails) > area) {
    pays = fails;
    fails *= 2;
    if (fails * mean_s > kEndless * own.duration_s) return BreakEven{};
  }
  while (true) {
    const double middle = 0.5 * (pays + fails);
    if (middle <= pays || middle >= fails) break;
    (areaAt(middle) > area ? pays : fails) = middle;
  }
  return BreakEven{.latency_s = fails * mean_s, .factor = fails};
}

}  // namespace hydrabench

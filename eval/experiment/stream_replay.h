// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "eval/evaluation/evaluation_config.h"
#include "eval/experiment/candidate_geometry.h"
#include "eval/experiment/latency_model.h"
#include "metrics/matching.h"
#include "metrics/stream_schedule.h"

namespace hydrabench {

/// What a method asked its shape estimator for on one world, and what the answers are worth.
struct StreamWorld {
  std::string dataset;
  std::uint64_t seed = 0;
  std::string method;
  std::vector<ShapeCandidate> candidates;  ///< one request each, in the order of the run
  DecisionConfig decision;                 ///< of the run
  Counting counting;
  std::int64_t start_ns = 0;             ///< first frame that was mapped
  std::int64_t end_ns = 0;               ///< last one
  double request_after_s = 0;            ///< from an object's last observation to its request
  std::optional<LatencyModel> measured;  ///< of the run itself, where it was timed
};

struct StreamConfig {
  int servers = 1;  ///< estimators that work side by side
  double deadline_s = 5;
  bool deadline_from_last_seen = false;  ///< false: from the request
  double after_s = 0;                    ///< what counts of the time after the last frame, >= 0
  std::uint64_t seed = 1;                ///< of latencies that are drawn
};

/// One request, in seconds since the first frame.
struct StreamedShape {
  std::uint64_t seed = 0;  ///< of the world
  std::uint64_t track = 0;
  double last_seen_s = 0;
  StreamRequest request;
  StreamCompletion completion;
};

/// F1 over time at one threshold, under one matching; docs/metrics.md has the formulae.
struct StreamScore {
  Threshold threshold;
  Matching matching = Matching::kExists;
  std::vector<StreamStep> f1 = {};  ///< 0 before its first step
  double area = 0;                  ///< mean of F1 over the time that counts
  double f1_at_end = 0;             ///< when the time that counts is over
  double f1_of_all = 0;             ///< when the last shape is there
};

struct StreamOutcome {
  double duration_s = 0;  ///< that counts; of several worlds the longest
  std::vector<StreamedShape> shapes;
  std::vector<StreamStep> queue;  ///< requests that wait; of several worlds their mean
  double longest_queue = 0;
  double mean_queue = 0;
  std::vector<StreamScore> scores;  ///< per threshold of the config and matching

  std::size_t misses() const;
  double meanLatency() const;  ///< 0 without shapes
  double lastReady() const;    ///< end of the last one; 0 without shapes
};

/// Replays the requests of one method with other latencies. Nothing is estimated again: the shapes
/// are those of the run, and are objects from the moment they are ready, by the run's own rule over
/// those that are ready. The mapper never waits. Worlds lie over each other from their first frames
/// on, each with estimators of its own; counts are added, then F1 is derived.
class StreamReplay {
 public:
  /// @param worlds  at least one
  StreamReplay(std::vector<StreamWorld> worlds, const EvaluationConfig& config);

  /// @param latency  nullopt: that which was measured of each world's run; the worlds must have it
  /// @param factor   of every latency
  StreamOutcome run(const std::optional<LatencyModel>& latency, const StreamConfig& config,
                    double factor = 1) const;

  const std::vector<StreamWorld>& worlds() const { return worlds_; }
  /// What is scored, in the order of StreamOutcome::scores; without scores.
  const std::vector<StreamScore>& scored() const { return scored_; }

 private:
  using Counts = std::vector<DetectionCounts>;  ///< per score
  const Counts& countsOf(std::size_t world, const std::vector<bool>& ready) const;
  std::vector<StreamedShape> schedule(const StreamWorld& world,
                                      const std::optional<LatencyModel>& latency,
                                      const StreamConfig& config, double factor) const;

  std::vector<StreamWorld> worlds_;  ///< of their candidates what a decision looks at
  std::vector<CandidateGeometry> geometry_;
  std::vector<StreamScore> scored_;
  /// Per world what was counted already. Not for several threads at once.
  mutable std::vector<std::map<std::vector<bool>, Counts>> counted_;
};

/// How slow a better estimator may be until it no longer pays against a faster one.
struct BreakEven {
  /// Mean of its latencies at which its area falls to the other's; nullopt where it does not, even
  /// at a latency of many recordings.
  std::optional<double> latency_s;
  double factor = 0;  ///< of its own latencies; with latency_s
};
/// Scales the latencies of `slower` until its area at score k is `area`, by bisection to the last
/// bit. Where F1 falls with more shapes there may be several such latencies; it is one of them.
/// nullopt where its area is not above `area` even with no latency at all, or where its own
/// latencies are all 0 and leave nothing to scale.
std::optional<BreakEven> breakEven(const StreamReplay& slower,
                                   const std::optional<LatencyModel>& latency,
                                   const StreamConfig& config, std::size_t k, double area);

}  // namespace hydrabench

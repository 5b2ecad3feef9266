// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "eval/experiment/timing.h"

namespace hydrabench {

/// How long a shape estimator works on an object: a distribution to draw from.
struct LatencyModel {
  std::string label;  ///< as printed, with where it comes from
  /// The latency [s], >= 0, that a share of all objects stays below; ascending, for shares in
  /// [0, 1). Of a share drawn uniformly it makes a latency.
  std::function<double(double share)> quantile_s;
};

LatencyModel constantLatency(double seconds);

/// What was measured one by one, each as likely as another. Not empty.
LatencyModel sampledLatency(const std::string& label, std::vector<double> seconds);

/// What is known of a distribution of which the single values are not [s].
struct LatencySummary {
  std::optional<double> mean;
  double p50 = 0;  ///< ascending from here on
  double p90 = 0;
  double p99 = 0;
  double max = 0;
};
/// Straight lines through the percentiles. It starts as low as the mean asks for, or as far below
/// the median as p90 is above it where there is no mean; between 0 and the median either way.
LatencyModel summarizedLatency(const std::string& label, const LatencySummary& summary);

/// The calls of the stage `estimate` of a run.
LatencyModel measuredLatency(const TimingRow& row);

/// A mean and a range: low + (high - low) share^k, k such that the mean is met. low < mean < high.
/// The shape between the three numbers is ours.
LatencyModel rangedLatency(const std::string& label, double mean_s, double low_s, double high_s);

/// Names of the published latencies: those of CRISP and SAM3D in Hydra++, indoors (uHumans2) and
/// outdoors (Kimera-Multi), from its project page; their hardware is not stated.
std::vector<std::string> publishedLatencies();

/// Reads the words of the command line: a number of seconds; "mean=1.2,p50=1,p90=2,p99=3,max=4" in
/// seconds, where what is left out is that before it; "published:NAME";
/// "FILE.csv:ESTIMATOR", views.csv of `hydrabench estimate`. Throws InputError.
LatencyModel readLatency(const std::string& text);

}  // namespace hydrabench

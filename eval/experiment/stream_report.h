// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "eval/experiment/stream_replay.h"
#include "eval/report/plot.h"

namespace hydrabench {

/// One replay: a method with one model of its latencies, on one world or on all of a dataset.
struct StreamRow {
  std::string dataset;
  std::string seed;  ///< "pooled" for several worlds
  std::string method;
  std::string latency;  ///< label of the model
  StreamOutcome outcome;
  std::vector<double> instant_areas;  ///< per score: what its area were without any latency
};

/// Two methods of a dataset, the better of which is scaled against the other.
struct BreakEvenRow {
  std::string dataset;
  std::string seed;
  std::string better;
  std::string better_latency;  ///< label of the model that is scaled
  std::string other;
  std::string other_latency;
  Threshold threshold;
  Matching matching = Matching::kExists;
  double other_area = 0;
  double better_area = 0;    ///< at its own latencies
  double own_latency_s = 0;  ///< their mean
  BreakEven result;
};

struct StreamReport {
  StreamConfig config;
  std::vector<StreamRow> rows;  ///< a dataset's together
  std::vector<BreakEvenRow> break_even;
};

/// Replays every method with its latencies and compares them pairwise. Worlds of a dataset are
/// replayed one by one and, where there are several, together.
/// @param worlds     of every dataset the same for each method
/// @param latencies  per method, in this order; nullopt: what was measured of its runs
struct StreamMethod {
  std::string name;
  std::vector<std::optional<LatencyModel>> latencies;  ///< the first is scaled for the break-even
};
StreamReport replayStreams(const std::vector<StreamWorld>& worlds,
                           const std::vector<StreamMethod>& methods, const StreamConfig& config,
                           const EvaluationConfig& evaluation);

std::string streamCsv(const StreamReport& report);      ///< a line per row and score
std::string f1OverTimeCsv(const StreamReport& report);  ///< the exact steps
std::string queueCsv(const StreamReport& report);       ///< the same of the queue
std::string requestsCsv(const StreamReport& report);    ///< a line per request; no pooled rows
std::string breakEvenCsv(const StreamReport& report);
/// The tables; of a dataset with several worlds the pooled rows only.
std::string streamMarkdown(const StreamReport& report);
/// F1 over time at each threshold and the queue, for one dataset and matching.
Plot streamPlot(const StreamReport& report, const std::string& dataset, Matching matching);
std::vector<std::string> streamDatasets(const StreamReport& report);

}  // namespace hydrabench

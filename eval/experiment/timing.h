// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "core/pipeline/stage_times.h"

namespace hydrabench {

/// One stage of one method on one world; a line of timing.csv.
struct TimingRow {
  std::string dataset;
  std::string seed;
  std::string method;
  std::string stage;   ///< "frame": all of process(); "finish": the end of the run
  std::size_t n = 0;   ///< calls
  double mean_ms = 0;  ///< wall clock, as are the percentiles (nearest rank)
  double p50_ms = 0;
  double p90_ms = 0;
  double p99_ms = 0;
  double max_ms = 0;
  double cpu_s = 0;         ///< summed over calls, all threads
  double peak_rss_mib = 0;  ///< of the whole process so far, world and other methods included
};

/// Calls of each stage so far; what comes before counts as warm-up.
using StageCounts = std::map<std::string, std::size_t>;
StageCounts stageCounts(const StageTimes& times);

/// @param warm_up  calls that are left out, per stage; a stage with no others keeps them
std::vector<TimingRow> timingRows(const std::string& dataset, const std::string& seed,
                                  const std::string& method, const StageTimes& times,
                                  const StageCounts& warm_up);

std::string timingCsv(const std::vector<TimingRow>& rows);
/// Throws InputError naming file, line and column.
std::vector<TimingRow> readTimingCsv(const std::filesystem::path& path);
/// A few lines for the terminal: per world and method the time per frame and its multiple of real
/// time.
/// @param frame_period_s  mean time between frames per dataset
std::string timingSummary(const std::vector<TimingRow>& rows,
                          const std::map<std::string, double>& frame_period_s);

double peakRssMib();  ///< of this process

}  // namespace hydrabench

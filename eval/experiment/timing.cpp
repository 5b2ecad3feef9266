// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/experiment/timing.h"

#include <algorithm>
#include <cmath>
#include <sys/resource.h>

#include <fmt/format.h>

#include "eval/evaluation/csv.h"

namespace hydrabench {
namespace {

const std::vector<std::string> kColumns = {"dataset", "seed",    "method", "stage",
                                           "n",       "mean_ms", "p50_ms", "p90_ms",
                                           "p99_ms",  "max_ms",  "cpu_s",  "peak_rss_mib"};

/// Smallest value that at least this share of the values do not exceed.
double percentile(const std::vector<double>& ascending, double share) {
  const double rank = std::ceil(share * static_cast<double>(ascending.size()));
  return ascending[static_cast<std::size_t>(std::max(1.0, rank)) - 1];
}

}  // namespace

StageCounts stageCounts(const StageTimes& times) {
  StageCounts counts;
  for (const StageTimes::Stage& stage : times.stages()) counts[stage.name] = stage.samples.size();
  return counts;
}

std::vector<TimingRow> timingRows(const std::string& dataset, const std::string& seed,
                                  const std::string& method, const StageTimes& times,
                                  const StageCounts& warm_up) {
  std::vector<TimingRow> rows;
  for (const StageTimes::Stage& stage : times.stages()) {
    const auto found = warm_up.find(stage.name);
    std::size_t first = found == warm_up.end() ? 0 : found->second;
    if (first >= stage.samples.size()) first = 0;
    TimingRow row{.dataset = dataset, .seed = seed, .method = method, .stage = stage.name};
    std::vector<double> wall_ms;
    for (std::size_t i = first; i < stage.samples.size(); ++i) {
      wall_ms.push_back(stage.samples[i].wall_ms);
      row.mean_ms += stage.samples[i].wall_ms;
      row.cpu_s += stage.samples[i].cpu_ms / 1e3;
    }
    if (wall_ms.empty()) continue;
    std::sort(wall_ms.begin(), wall_ms.end());
    row.n = wall_ms.size();
    row.mean_ms /= static_cast<double>(row.n);
    row.p50_ms = percentile(wall_ms, 0.5);
    row.p90_ms = percentile(wall_ms, 0.9);
    row.p99_ms = percentile(wall_ms, 0.99);
    row.max_ms = wall_ms.back();
    row.peak_rss_mib = peakRssMib();
    rows.push_back(std::move(row));
  }
  return rows;
}

std::string timingCsv(const std::vector<TimingRow>& rows) {
  std::string text = csvLine(kColumns);
  const auto cell = [](double value) { return fmt::format("{:.3f}", value); };
  for (const TimingRow& row : rows) {
    text += csvLine({row.dataset, row.seed, row.method, row.stage, std::to_string(row.n),
                     cell(row.mean_ms), cell(row.p50_ms), cell(row.p90_ms), cell(row.p99_ms),
                     cell(row.max_ms), cell(row.cpu_s), cell(row.peak_rss_mib)});
  }
  return text;
}

std::vector<TimingRow> readTimingCsv(const std::filesystem::path& path) {
  const CsvTable table = readCsv(path, kColumns);
  std::vector<TimingRow> rows;
  for (std::size_t i = 0; i < table.rows.size(); ++i) {
    const auto number = [&](std::size_t column) { return table.number(i, column).value_or(0); };
    TimingRow& row = rows.emplace_back();
    row.dataset = table.rows[i][0];
    row.seed = table.rows[i][1];
    row.method = table.rows[i][2];
    row.stage = table.rows[i][3];
    row.n = static_cast<std::size_t>(number(4));
    row.mean_ms = number(5);
    row.p50_ms = number(6);
    row.p90_ms = number(7);
    row.p99_ms = number(8);
    row.max_ms = number(9);
    row.cpu_s = number(10);
    row.peak_rss_mib = number(11);
  }
  return rows;
}

std::string timingSummary(const std::vector<TimingRow>& rows,
                          const std::map<std::string, double>& frame_period_s) {
  std::string text;
  for (const TimingRow& row : rows) {
    if (row.stage != "frame") continue;
    const auto finish = std::find_if(rows.begin(), rows.end(), [&](const TimingRow& other) {
      return other.stage == "finish" && other.dataset == row.dataset && other.seed == row.seed &&
             other.method == row.method;
    });
    const double finish_ms = finish == rows.end() ? 0 : finish->mean_ms;
    const auto frames = static_cast<double>(row.n);
    text +=
        fmt::format("{:<16} {:<20} seed {:<3} frame p50 {:7.1f} ms  p99 {:7.1f} ms  end {:5.1f} s",
                    row.method, row.dataset, row.seed, row.p50_ms, row.p99_ms, finish_ms / 1e3);
    const auto period = frame_period_s.find(row.dataset);
    if (period != frame_period_s.end() && period->second > 0) {
      const double factor = frames * period->second / ((frames * row.mean_ms + finish_ms) / 1e3);
      text += fmt::format("  {:5.1f}x real time", factor);
    }
    text += "\n";
  }
  return text;
}

double peakRssMib() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024;
}

}  // namespace hydrabench

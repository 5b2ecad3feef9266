// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/experiment/latency_table.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <fmt/format.h>

#include "eval/evaluation/csv.h"

namespace hydrabench {
namespace {

constexpr const char* kTotal = "total";

/// The calls of one estimator on one dataset.
struct Calls {
  std::string dataset;
  std::string estimator;
  std::vector<const SingleViewRow*> rows;
};

std::vector<Calls> callsOf(const std::vector<SingleViewRow>& rows) {
  std::vector<Calls> all;
  for (const SingleViewRow& row : rows) {
    const auto found = std::find_if(all.begin(), all.end(), [&](const Calls& calls) {
      return calls.dataset == row.dataset && calls.estimator == row.estimator;
    });
    Calls& calls =
        found != all.end() ? *found : all.emplace_back(Calls{row.dataset, row.estimator, {}});
    calls.rows.push_back(&row);
  }
  return all;
}

/// How many objects got no shape, and why.
std::string noteOn(const Calls& calls) {
  std::vector<std::pair<std::string, std::size_t>> failures;
  std::size_t count = 0;
  for (const SingleViewRow* row : calls.rows) {
    if (row->failure.empty()) continue;
    ++count;
    const auto found = std::find_if(failures.begin(), failures.end(),
                                    [&](const auto& kind) { return kind.first == row->failure; });
    if (found != failures.end()) {
      ++found->second;
    } else {
      failures.emplace_back(row->failure, 1);
    }
  }
  if (count == 0) return "";
  // Of one that never answered the first failure is the cause of all.
  if (count == calls.rows.size()) return "not available: " + failures.front().first;
  const auto most =
      std::max_element(failures.begin(), failures.end(),
                       [](const auto& a, const auto& b) { return a.second < b.second; });
  return fmt::format("{} of {} without a shape{}: {}", count, calls.rows.size(),
                     failures.size() > 1 ? ", most often" : "", most->first);
}

/// As timing rows have them; the total first.
StageTimes timesOf(const Calls& calls) {
  StageTimes times;
  for (const SingleViewRow* row : calls.rows) {
    if (row->failure.empty()) times.add(kTotal, {row->wall_ms.at(kTotal), 0});
  }
  for (const SingleViewRow* row : calls.rows) {
    if (!row->failure.empty()) continue;
    for (const auto& [stage, wall_ms] : row->wall_ms) {
      if (stage != kTotal) times.add(stage, {wall_ms, 0});
    }
  }
  return times;
}

}  // namespace

std::vector<LatencyRow> latencyRows(const std::vector<SingleViewRow>& rows) {
  std::vector<LatencyRow> table;
  for (const Calls& calls : callsOf(rows)) {
    std::vector<TimingRow> stages =
        timingRows(calls.dataset, "", calls.estimator, timesOf(calls), {});
    if (stages.empty()) stages.emplace_back().stage = kTotal;
    for (TimingRow& times : stages) {
      const std::string stage = times.stage;
      table.push_back({calls.dataset, calls.estimator, stage, calls.rows.size(), std::move(times),
                       stage == kTotal ? noteOn(calls) : ""});
    }
  }
  return table;
}

std::string latencyCsv(const std::vector<LatencyRow>& rows) {
  std::string text = csvLine({"dataset", "estimator", "stage", "objects", "n", "mean_ms", "p50_ms",
                              "p90_ms", "p99_ms", "max_ms", "note"});
  for (const LatencyRow& row : rows) {
    const auto cell = [&](double value) {
      return row.times.n == 0 ? std::string() : fmt::format("{:.3f}", value);
    };
    text +=
        csvLine({row.dataset, row.estimator, row.stage, std::to_string(row.objects),
                 std::to_string(row.times.n), cell(row.times.mean_ms), cell(row.times.p50_ms),
                 cell(row.times.p90_ms), cell(row.times.p99_ms), cell(row.times.max_ms), row.note});
  }
  return text;
}

std::string latencyMarkdown(const std::vector<LatencyRow>& rows) {
  std::string text =
      "| dataset | estimator | stage | n | mean [ms] | p50 | p90 | p99 | max | |\n"
      "|---|---|---|---:|---:|---:|---:|---:|---:|---|\n";
  for (const LatencyRow& row : rows) {
    const auto cell = [&](double value) {
      return row.times.n == 0 ? std::string("n/a") : fmt::format("{:.1f}", value);
    };
    text += fmt::format("| {} | {} | {} | {} | {} | {} | {} | {} | {} | {} |\n", row.dataset,
                        row.estimator, row.stage, row.times.n, cell(row.times.mean_ms),
                        cell(row.times.p50_ms), cell(row.times.p90_ms), cell(row.times.p99_ms),
                        cell(row.times.max_ms), row.note);
  }
  return text;
}

Plot latencyPlot(const std::vector<SingleViewRow>& rows) {
  Plot plot;
  double least = std::numeric_limits<double>::infinity();
  double most = 0;
  for (const Calls& calls : callsOf(rows)) {
    const bool is_new = plot.panels.empty() || plot.panels.back().title != calls.dataset;
    PlotPanel& panel = is_new ? plot.panels.emplace_back() : plot.panels.back();
    panel.title = calls.dataset;
    panel.y_label = "time per object [ms]";
    panel.log_y = true;
    PlotViolin& violin = panel.violins.emplace_back();
    violin.label = calls.estimator;
    for (const SingleViewRow* row : calls.rows) {
      if (!row->failure.empty() || !(row->wall_ms.at(kTotal) > 0)) continue;
      violin.values.push_back(row->wall_ms.at(kTotal));
      least = std::min(least, violin.values.back());
      most = std::max(most, violin.values.back());
    }
  }
  if (most == 0) return {};
  const double low = std::pow(10, std::floor(std::log10(least)));
  const double high = std::pow(10, std::floor(std::log10(most)) + 1);
  for (PlotPanel& panel : plot.panels) panel.y_range = {low, high};
  return plot;
}

}  // namespace hydrabench

// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/experiment/stream_report.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <set>

#include <fmt/format.h>

#include "eval/evaluation/csv.h"
#include "eval/evaluation/score_row.h"
#include "eval/report/comparison_table.h"

namespace hydrabench {
namespace {

constexpr const char* kMeasured = "measured";

std::string labelOf(const std::optional<LatencyModel>& latency) {
  return latency ? latency->label : kMeasured;
}

/// A method on one world, or on several.
struct Competitor {
  const StreamMethod* method;
  StreamReplay replay;
  std::vector<StreamOutcome> outcomes;  ///< per latency
  std::vector<double> instant_areas;
};

std::vector<double> areasOf(const StreamOutcome& outcome) {
  std::vector<double> areas;
  for (const StreamScore& score : outcome.scores) areas.push_back(score.area);
  return areas;
}

/// Who is better if nothing takes time, scaled against the other at each of the other's latencies.
void addBreakEven(const Competitor& better, const Competitor& other, const StreamRow& place,
                  StreamReport& report) {
  const std::optional<LatencyModel>& own = better.method->latencies.front();
  for (std::size_t k = 0; k < better.instant_areas.size(); ++k) {
    if (!(better.instant_areas[k] > other.instant_areas[k])) continue;
    for (std::size_t l = 0; l < other.outcomes.size(); ++l) {
      const double area = other.outcomes[l].scores[k].area;
      const auto result = breakEven(better.replay, own, report.config, k, area);
      if (!result) continue;
      const StreamScore& score = better.outcomes.front().scores[k];
      report.break_even.push_back({.dataset = place.dataset,
                                   .seed = place.seed,
                                   .better = better.method->name,
                                   .better_latency = labelOf(own),
                                   .other = other.method->name,
                                   .other_latency = labelOf(other.method->latencies[l]),
                                   .threshold = score.threshold,
                                   .matching = score.matching,
                                   .other_area = area,
                                   .better_area = score.area,
                                   .own_latency_s = better.outcomes.front().meanLatency(),
                                   .result = *result});
    }
  }
}

/// @param worlds  of one dataset: one, or all; of every method
void replayPlace(const std::vector<StreamWorld>& worlds, const std::vector<StreamMethod>& methods,
                 const EvaluationConfig& evaluation, StreamReport& report) {
  std::set<std::uint64_t> seeds;
  for (const StreamWorld& world : worlds) seeds.insert(world.seed);
  StreamRow row;
  row.dataset = worlds.front().dataset;
  row.seed = seeds.size() > 1 ? kPooledSeed : std::to_string(*seeds.begin());
  std::vector<Competitor> competitors;
  for (const StreamMethod& method : methods) {
    std::vector<StreamWorld> of_method;
    for (const StreamWorld& world : worlds) {
      if (world.method == method.name) of_method.push_back(world);
    }
    if (of_method.empty()) continue;
    Competitor& competitor = competitors.emplace_back(
        Competitor{&method, StreamReplay(std::move(of_method), evaluation), {}, {}});
    competitor.instant_areas = areasOf(competitor.replay.run(constantLatency(0), report.config));
    for (const std::optional<LatencyModel>& latency : method.latencies) {
      competitor.outcomes.push_back(competitor.replay.run(latency, report.config));
      row.method = method.name;
      row.latency = labelOf(latency);
      row.outcome = competitor.outcomes.back();
      row.instant_areas = competitor.instant_areas;
      report.rows.push_back(row);
    }
  }
  for (const Competitor& better : competitors) {
    for (const Competitor& other : competitors) {
      if (&better != &other) addBreakEven(better, other, row, report);
    }
  }
}

/// Rows of a dataset that are worth a table: all its worlds together, where there are several.
template <typename Row>
std::vector<const Row*> tableRows(const std::vector<Row>& rows, const std::string& dataset) {
  std::vector<const Row*> chosen;
  const bool pooled = std::any_of(rows.begin(), rows.end(), [&](const Row& row) {
    return row.dataset == dataset && row.seed == kPooledSeed;
  });
  for (const Row& row : rows) {
    if (row.dataset == dataset && (!pooled || row.seed == kPooledSeed)) chosen.push_back(&row);
  }
  return chosen;
}

std::string breakEvenText(const BreakEven& result) {
  return result.latency_s
             ? fmt::format("{:.3g} s ({:.3g} times its own)", *result.latency_s, result.factor)
             : "any";
}

}  // namespace

StreamReport replayStreams(const std::vector<StreamWorld>& worlds,
                           const std::vector<StreamMethod>& methods, const StreamConfig& config,
                           const EvaluationConfig& evaluation) {
  StreamReport report{.config = config, .rows = {}, .break_even = {}};
  std::vector<std::string> datasets;
  for (const StreamWorld& world : worlds) {
    if (std::find(datasets.begin(), datasets.end(), world.dataset) == datasets.end()) {
      datasets.push_back(world.dataset);
    }
  }
  for (const std::string& dataset : datasets) {
    std::vector<StreamWorld> of_dataset;
    std::vector<std::uint64_t> seeds;
    for (const StreamWorld& world : worlds) {
      if (world.dataset != dataset) continue;
      of_dataset.push_back(world);
      if (std::find(seeds.begin(), seeds.end(), world.seed) == seeds.end()) {
        seeds.push_back(world.seed);
      }
    }
    for (const std::uint64_t seed : seeds) {
      std::vector<StreamWorld> of_seed;
      std::copy_if(of_dataset.begin(), of_dataset.end(), std::back_inserter(of_seed),
                   [&](const StreamWorld& world) { return world.seed == seed; });
      replayPlace(of_seed, methods, evaluation, report);
    }
    if (seeds.size() > 1) replayPlace(of_dataset, methods, evaluation, report);
  }
  return report;
}

std::string streamCsv(const StreamReport& report) {
  std::string text =
      csvLine({"dataset", "seed", "method", "latency", "threshold_m", "matching", "requests",
               "mean_latency_s", "deadline_misses", "mean_queue", "longest_queue", "last_ready_s",
               "duration_s", "f1_area", "f1_area_instant", "f1_at_end", "f1_of_all"});
  for (const StreamRow& row : report.rows) {
    for (std::size_t k = 0; k < row.outcome.scores.size(); ++k) {
      const StreamScore& score = row.outcome.scores[k];
      text +=
          csvLine({row.dataset, row.seed, row.method, row.latency, csvNumber(score.threshold.value),
                   name(score.matching), std::to_string(row.outcome.shapes.size()),
                   csvNumber(row.outcome.meanLatency()), std::to_string(row.outcome.misses()),
                   csvNumber(row.outcome.mean_queue), csvNumber(row.outcome.longest_queue),
                   csvNumber(row.outcome.lastReady()), csvNumber(row.outcome.duration_s),
                   csvNumber(score.area), csvNumber(row.instant_areas[k]),
                   csvNumber(score.f1_at_end), csvNumber(score.f1_of_all)});
    }
  }
  return text;
}

std::string f1OverTimeCsv(const StreamReport& report) {
  std::string text =
      csvLine({"dataset", "seed", "method", "latency", "threshold_m", "matching", "time_s", "f1"});
  for (const StreamRow& row : report.rows) {
    for (const StreamScore& score : row.outcome.scores) {
      for (const StreamStep& step : score.f1) {
        text += csvLine({row.dataset, row.seed, row.method, row.latency,
                         csvNumber(score.threshold.value), name(score.matching),
                         csvNumber(step.time_s), csvNumber(step.value)});
      }
    }
  }
  return text;
}

std::string queueCsv(const StreamReport& report) {
  std::string text = csvLine({"dataset", "seed", "method", "latency", "time_s", "waiting"});
  for (const StreamRow& row : report.rows) {
    for (const StreamStep& step : row.outcome.queue) {
      text += csvLine({row.dataset, row.seed, row.method, row.latency, csvNumber(step.time_s),
                       csvNumber(step.value)});
    }
  }
  return text;
}

std::string requestsCsv(const StreamReport& report) {
  std::string text = csvLine({"dataset", "seed", "method", "latency", "track", "last_seen_s",
                              "requested_s", "begun_s", "ready_s", "latency_s", "due_s", "late"});
  for (const StreamRow& row : report.rows) {
    if (row.seed == kPooledSeed) continue;
    for (const StreamedShape& shape : row.outcome.shapes) {
      text += csvLine({row.dataset, row.seed, row.method, row.latency, std::to_string(shape.track),
                       csvNumber(shape.last_seen_s), csvNumber(shape.request.arrival_s),
                       csvNumber(shape.completion.start_s), csvNumber(shape.completion.end_s),
                       csvNumber(shape.request.latency_s), csvNumber(shape.request.due_s),
                       shape.completion.late ? "1" : "0"});
    }
  }
  return text;
}

std::string breakEvenCsv(const StreamReport& report) {
  std::string text =
      csvLine({"dataset", "seed", "better", "better_latency", "other", "other_latency",
               "threshold_m", "matching", "other_area", "better_area", "own_mean_latency_s",
               "break_even_latency_s", "factor"});
  for (const BreakEvenRow& row : report.break_even) {
    text += csvLine({row.dataset, row.seed, row.better, row.better_latency, row.other,
                     row.other_latency, csvNumber(row.threshold.value), name(row.matching),
                     csvNumber(row.other_area), csvNumber(row.better_area),
                     csvNumber(row.own_latency_s), csvNumber(row.result.latency_s),
                     row.result.latency_s ? csvNumber(row.result.factor) : ""});
  }
  return text;
}

std::string streamMarkdown(const StreamReport& report) {
  std::string text;
  for (const std::string& dataset : streamDatasets(report)) {
    const auto rows = tableRows(report.rows, dataset);
    text += fmt::format(
        "## {}, {}\n\n{:.1f} s count; estimators side by side: {}; deadline {:g} s after the {}. "
        "Means of the queue are over\nthe time that counts{}.\n\n"
        "| method | latency | shapes asked for | mean latency [s] | late | longest queue | mean "
        "queue | last ready [s] |\n|---|---|---:|---:|---:|---:|---:|---:|\n",
        dataset,
        rows.front()->seed == kPooledSeed ? "worlds together" : "seed " + rows.front()->seed,
        rows.front()->outcome.duration_s, report.config.servers, report.config.deadline_s,
        report.config.deadline_from_last_seen ? "last observation" : "request",
        rows.front()->seed == kPooledSeed ? ", and over worlds" : "");
    for (const StreamRow* row : rows) {
      const StreamOutcome& outcome = row->outcome;
      text += fmt::format("| {} | {} | {} | {:.3g} | {} | {:g} | {:.2f} | {:.1f} |\n",
                          methodLabel(row->method), row->latency, outcome.shapes.size(),
                          outcome.meanLatency(), outcome.misses(), outcome.longest_queue,
                          outcome.mean_queue, outcome.lastReady());
    }
    text +=
        "\n| tau_d | matching | method | latency | mean F1 over time | without latency | F1 at "
        "the end | F1 of all shapes |\n|---|---|---|---|---:|---:|---:|---:|\n";
    for (std::size_t k = 0; k < rows.front()->outcome.scores.size(); ++k) {
      for (const StreamRow* row : rows) {
        const StreamScore& score = row->outcome.scores[k];
        text += fmt::format("| {:g} m | {} | {} | {} | {:.3f} | {:.3f} | {:.3f} | {:.3f} |\n",
                            score.threshold.value, name(score.matching), methodLabel(row->method),
                            row->latency, score.area, row->instant_areas[k], score.f1_at_end,
                            score.f1_of_all);
      }
    }
    const auto pairs = tableRows(report.break_even, dataset);
    if (!pairs.empty()) {
      text +=
          "\n| tau_d | matching | better | than | whose mean F1 is | its own at its own mean "
          "latency | pays up to a mean latency of |\n|---|---|---|---|---:|---|---:|\n";
    }
    for (const BreakEvenRow* row : pairs) {
      text += fmt::format("| {:g} m | {} | {}, {} | {}, {} | {:.3f} | {:.3f} at {:.3g} s | {} |\n",
                          row->threshold.value, name(row->matching), methodLabel(row->better),
                          row->better_latency, methodLabel(row->other), row->other_latency,
                          row->other_area, row->better_area, row->own_latency_s,
                          breakEvenText(row->result));
    }
    text += "\n";
  }
  return text;
}

Plot streamPlot(const StreamReport& report, const std::string& dataset, Matching matching) {
  const auto rows = tableRows(report.rows, dataset);
  Plot plot;
  if (rows.empty()) return plot;
  const double duration_s = rows.front()->outcome.duration_s;
  const auto panelOf = [&](const std::string& title, const std::string& y_label) -> PlotPanel& {
    PlotPanel& panel = plot.panels.emplace_back();
    panel.title = title;
    panel.x_label = "time since the first frame [s]";
    panel.y_label = y_label;
    panel.x_range = {0, duration_s};
    return panel;
  };
  const auto curveOf = [&](const StreamRow& row, const std::vector<StreamStep>& steps) {
    PlotCurve curve;
    curve.label = methodLabel(row.method) + ", " + row.latency;
    curve.steps = true;
    curve.points.emplace_back(0, 0);
    for (const StreamStep& step : steps) {
      if (step.time_s < duration_s) curve.points.emplace_back(step.time_s, step.value);
    }
    return curve;
  };
  for (std::size_t k = 0; k < rows.front()->outcome.scores.size(); ++k) {
    const StreamScore& first = rows.front()->outcome.scores[k];
    if (first.matching != matching) continue;
    PlotPanel& panel = panelOf(fmt::format("F1 within {:g} m", first.threshold.value), "F1");
    for (const StreamRow* row : rows) {
      panel.curves.push_back(curveOf(*row, row->outcome.scores[k].f1));
    }
  }
  PlotPanel& queue = panelOf("Requests that wait", "requests");
  double longest = 1;
  for (const StreamRow* row : rows) {
    queue.curves.push_back(curveOf(*row, row->outcome.queue));
    for (const Eigen::Vector2d& point : queue.curves.back().points) {
      longest = std::max(longest, point.y());
    }
  }
  queue.y_range = {0, 1.05 * longest};
  return plot;
}

std::vector<std::string> streamDatasets(const StreamReport& report) {
  std::vector<std::string> datasets;
  for (const StreamRow& row : report.rows) {
    if (datasets.empty() || datasets.back() != row.dataset) datasets.push_back(row.dataset);
  }
  return datasets;
}

}  // namespace hydrabench

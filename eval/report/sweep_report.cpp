// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/report/sweep_report.h"

#include <algorithm>
#include <charconv>
#include <map>
#include <optional>
#include <set>

#include <fmt/format.h>

#include "eval/evaluation/csv.h"
#include "eval/evaluation/scene_rows.h"

namespace hydrabench {
namespace {

std::optional<double> number(const std::string& text) {
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

/// Where the values of the first axis stand.
std::map<std::string, double> places(const SweepScores& sweep) {
  std::vector<std::string> values;
  for (const SweepScores::Point& point : sweep.points) {
    if (std::find(values.begin(), values.end(), point.values[0]) == values.end()) {
      values.push_back(point.values[0]);
    }
  }
  const bool numbers = std::all_of(values.begin(), values.end(), [](const std::string& value) {
    return number(value).has_value();
  });
  std::map<std::string, double> result;
  for (std::size_t i = 0; i < values.size(); ++i) {
    result[values[i]] = numbers ? *number(values[i]) : static_cast<double>(i + 1);
  }
  return result;
}

/// "voxel_size_m 0.1, preset hard", from axis `first` on.
std::string settings(const SweepScores& sweep, const SweepScores::Point& point, std::size_t first) {
  std::string text;
  for (std::size_t a = first; a < sweep.axes.size(); ++a) {
    text += fmt::format("{}{} {}", text.empty() ? "" : ", ", sweep.axes[a].name, point.values[a]);
  }
  return text;
}

/// The rows that stand for a dataset: the pooled ones where there are several worlds.
std::vector<const ScoreRow*> standing(const std::vector<ScoreRow>& rows,
                                      const std::string& dataset) {
  const bool pooled = std::any_of(rows.begin(), rows.end(), [&](const ScoreRow& row) {
    return row.dataset == dataset && row.seed == kPooledSeed;
  });
  std::vector<const ScoreRow*> result;
  for (const ScoreRow& row : rows) {
    if (row.dataset == dataset && (!pooled || row.seed == kPooledSeed)) result.push_back(&row);
  }
  return result;
}

struct Measure {
  std::string metric;
  std::string title;
  std::string class_name;
  std::optional<double> threshold;  ///< nullopt: of the map as a whole
  std::string y_label = "score";

  bool isMeasuredBy(const ScoreRow& row, const std::string& matching) const {
    return row.class_name == class_name && row.metric == metric && row.threshold == threshold &&
           (!threshold || (row.matching == matching && row.threshold_kind == "tau_m"));
  }
};

/// F1 at each threshold in metres, and the box IoU at the largest; where the map as a whole is
/// scored, how complete its ground is and what it fills falsely.
std::vector<Measure> measures(const SweepScores& sweep) {
  std::set<double> thresholds;
  for (const SweepScores::Point& point : sweep.points) {
    for (const ScoreRow& row : point.rows) {
      if (row.threshold_kind == "tau_m" && row.threshold) thresholds.insert(*row.threshold);
    }
  }
  std::vector<Measure> result;
  for (const double threshold : thresholds) {
    result.push_back({"f1", fmt::format("F1 within {:g} m", threshold), kAllMicro, threshold});
  }
  if (!thresholds.empty()) {
    const double largest = *thresholds.rbegin();
    result.push_back(
        {"b_iou", fmt::format("box IoU of matches within {:g} m", largest), kAllMicro, largest});
  }
  const auto is_scene = [](const ScoreRow& row) { return row.class_name == kSceneClass; };
  if (std::any_of(sweep.points.begin(), sweep.points.end(), [&](const SweepScores::Point& point) {
        return std::any_of(point.rows.begin(), point.rows.end(), is_scene);
      })) {
    result.push_back({"ground_completeness", "ground completeness", kSceneClass, {}, "share"});
    result.push_back({"filled_volume", "falsely filled", kSceneClass, {}, "volume [m^3]"});
  }
  return result;
}

}  // namespace

std::vector<std::string> sweepDatasets(const SweepScores& sweep) {
  std::vector<std::string> datasets;
  for (const SweepScores::Point& point : sweep.points) {
    for (const ScoreRow& row : point.rows) {
      if (std::find(datasets.begin(), datasets.end(), row.dataset) == datasets.end()) {
        datasets.push_back(row.dataset);
      }
    }
  }
  return datasets;
}

std::string sweepCsv(const SweepScores& sweep) {
  std::string prefix;
  for (const SweepScores::Axis& axis : sweep.axes) prefix += axis.name + ",";
  std::string text = prefix + scoresCsv({});
  for (const SweepScores::Point& point : sweep.points) {
    std::string cells = csvLine(point.values);
    cells.back() = ',';  // instead of the end of the line
    const std::string rows = scoresCsv(point.rows);
    for (std::size_t begin = rows.find('\n') + 1; begin < rows.size();) {
      const std::size_t end = rows.find('\n', begin);
      text += cells + rows.substr(begin, end + 1 - begin);
      begin = end + 1;
    }
  }
  return text;
}

std::optional<SweepScores> readSweepCsv(const std::filesystem::path& path) {
  std::vector<std::vector<std::string>> records = readCsvCells(path);
  const std::vector<std::string>& scores = scoreColumns();
  if (records.empty() || records.front().size() <= scores.size()) return std::nullopt;
  const std::size_t axes = records.front().size() - scores.size();
  const auto first_score = records.front().begin() + static_cast<std::ptrdiff_t>(axes);
  if (!std::equal(first_score, records.front().end(), scores.begin())) return std::nullopt;

  const CsvTable table = readCsv(path, records.front());
  SweepScores sweep;
  for (std::size_t a = 0; a < axes; ++a) sweep.axes.push_back({table.columns[a], table.columns[a]});
  std::map<std::vector<std::string>, std::size_t> points;
  for (std::size_t i = 0; i < table.rows.size(); ++i) {
    const auto begin = table.rows[i].begin();
    const std::vector<std::string> values(begin, begin + static_cast<std::ptrdiff_t>(axes));
    const auto [place, is_new] = points.emplace(values, sweep.points.size());
    if (is_new) sweep.points.push_back({values, {}});
    sweep.points[place->second].rows.push_back(scoreRowOf(table, i, axes));
  }
  return sweep;
}

ComparisonTable sweepTable(const SweepScores& sweep) {
  std::vector<ScoreRow> rows;
  for (const SweepScores::Point& point : sweep.points) {
    const std::string at = settings(sweep, point, 0);
    for (ScoreRow row : point.rows) {
      row.method = fmt::format("{}, {}", methodLabel(row.method), at);
      rows.push_back(std::move(row));
    }
  }
  return comparisonTable(rows);
}

Plot sweepPlot(const SweepScores& sweep, const std::string& dataset, const std::string& matching) {
  const std::map<std::string, double> place = places(sweep);
  double low = place.begin()->second;
  double high = low;
  for (const auto& [value, x] : place) {
    low = std::min(low, x);
    high = std::max(high, x);
  }
  Plot plot;
  for (const Measure& measure : measures(sweep)) {
    PlotPanel& panel = plot.panels.emplace_back();
    panel.title = measure.title;
    panel.x_label = sweep.axes[0].title;
    panel.y_label = measure.y_label;
    panel.x_range = {low, high > low ? high : low + 1};
    std::map<std::string, std::size_t> curve_of;
    for (const SweepScores::Point& point : sweep.points) {
      for (const ScoreRow* row : standing(point.rows, dataset)) {
        if (!measure.isMeasuredBy(*row, matching)) continue;
        std::string label = methodLabel(row->method);
        if (const std::string more = settings(sweep, point, 1); !more.empty()) label += ", " + more;
        const auto [known, is_new] = curve_of.emplace(label, panel.curves.size());
        if (is_new) panel.curves.emplace_back().label = label;
        if (!row->value) continue;
        PlotCurve& curve = panel.curves[known->second];
        const double x = place.at(point.values[0]);
        curve.points.emplace_back(x, *row->value);
        if (row->ci95_low && row->ci95_high) {
          curve.band.push_back({x, *row->ci95_low, *row->ci95_high});
        }
      }
    }
    for (PlotCurve& curve : panel.curves) {
      std::sort(curve.points.begin(), curve.points.end(),
                [](const auto& a, const auto& b) { return a.x() < b.x(); });
      std::sort(curve.band.begin(), curve.band.end(),
                [](const auto& a, const auto& b) { return a.x < b.x; });
      for (const Eigen::Vector2d& point : curve.points) {
        if (point.y() > 1) panel.y_range.y() = std::max(panel.y_range.y(), 1.05 * point.y());
      }
    }
  }
  return plot;
}

}  // namespace hydrabench

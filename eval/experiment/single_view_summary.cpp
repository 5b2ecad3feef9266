// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include <fmt/format.h>

#include "core/types/random.h"
#include "eval/evaluation/csv.h"
#include "eval/experiment/single_view_study.h"

namespace hydrabench {
namespace {

using Values = std::vector<double>;
using Statistic = double (*)(Values&);

double median(Values& values) {
  const std::size_t middle = values.size() / 2;
  std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(middle),
                   values.end());
  const double upper = values[middle];
  if (values.size() % 2 == 1 || std::isinf(upper)) return upper;
  const double lower =
      *std::max_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(middle));
  return 0.5 * (lower + upper);
}

double mean(Values& values) {
  double sum = 0;
  for (const double value : values) sum += value;
  return sum / static_cast<double>(values.size());
}

double quantile(Values values, double share) {
  std::sort(values.begin(), values.end());
  const auto rank = static_cast<std::size_t>(std::ceil(share * static_cast<double>(values.size())));
  return values[std::clamp<std::size_t>(rank, 1, values.size()) - 1];
}

/// A statistic with its percentile interval. `values` not empty.
SingleViewSummary::Median resampled(const Values& values, Statistic statistic,
                                    const BootstrapConfig& config) {
  Values copy = values;
  SingleViewSummary::Median result;
  result.value = statistic(copy);
  result.interval = {result.value, result.value};
  if (config.resamples <= 0) return result;
  Random random(config.seed, 21);
  Values resamples;
  for (int i = 0; i < config.resamples; ++i) {
    for (double& value : copy) {
      value = values[random.index(static_cast<std::uint32_t>(values.size()))];
    }
    resamples.push_back(statistic(copy));
  }
  const double tail = (1 - config.confidence) / 2;
  result.interval = {quantile(resamples, tail), quantile(resamples, 1 - tail)};
  return result;
}

Values column(const std::vector<const SingleViewRow*>& rows,
              std::optional<double> SingleViewRow::*field, double worst) {
  Values values;
  for (const SingleViewRow* row : rows) values.push_back((row->*field).value_or(worst));
  return values;
}

SingleViewSummary summaryOf(const std::string& estimator, const std::string& class_name,
                            const std::vector<const SingleViewRow*>& rows,
                            const BootstrapConfig& bootstrap) {
  constexpr double kWorst = std::numeric_limits<double>::infinity();
  SingleViewSummary summary;
  summary.estimator = estimator;
  summary.class_name = class_name;
  summary.objects = rows.size();
  const auto medianOf = [&](std::optional<double> SingleViewRow::*field, double worst) {
    return resampled(column(rows, field, worst), median, bootstrap);
  };
  summary.chamfer_l1_m = medianOf(&SingleViewRow::chamfer_l1_m, kWorst);
  summary.center_error_m = medianOf(&SingleViewRow::center_error_m, kWorst);
  summary.v_iou = medianOf(&SingleViewRow::v_iou, 0);
  summary.b_iou = medianOf(&SingleViewRow::b_iou, 0);
  Values failures;
  Values times;
  for (const SingleViewRow* row : rows) {
    failures.push_back(row->failed() ? 1 : 0);
    times.push_back(row->wall_ms.at("total"));
  }
  summary.failure_share = resampled(failures, mean, bootstrap);
  summary.p50_ms = quantile(times, 0.5);
  summary.p99_ms = quantile(times, 0.99);
  return summary;
}

std::string cm(const SingleViewSummary::Median& median) {
  return fmt::format("{:.1f} ({:.1f}-{:.1f})", 100 * median.value, 100 * median.interval.low,
                     100 * median.interval.high);
}

std::string share(const SingleViewSummary::Median& median) {
  return fmt::format("{:.3f} ({:.3f}-{:.3f})", median.value, median.interval.low,
                     median.interval.high);
}

}  // namespace

std::vector<SingleViewSummary> summarize(const std::vector<SingleViewRow>& rows,
                                         const BootstrapConfig& bootstrap) {
  std::vector<std::string> estimators;
  std::set<std::string> classes;
  for (const SingleViewRow& row : rows) {
    if (std::find(estimators.begin(), estimators.end(), row.estimator) == estimators.end()) {
      estimators.push_back(row.estimator);
    }
    classes.insert(row.class_name);
  }
  std::vector<SingleViewSummary> summaries;
  for (const std::string& estimator : estimators) {
    std::map<std::string, std::vector<const SingleViewRow*>> groups;
    for (const SingleViewRow& row : rows) {
      if (row.estimator != estimator) continue;
      groups["all"].push_back(&row);
      groups[row.class_name].push_back(&row);
    }
    summaries.push_back(summaryOf(estimator, "all", groups["all"], bootstrap));
    for (const std::string& name : classes) {
      if (!groups[name].empty()) {
        summaries.push_back(summaryOf(estimator, name, groups[name], bootstrap));
      }
    }
  }
  return summaries;
}

std::string viewsCsv(const std::vector<SingleViewRow>& rows) {
  std::set<std::string> stages;
  for (const SingleViewRow& row : rows) {
    for (const auto& [stage, _] : row.wall_ms) stages.insert(stage);
  }
  std::vector<std::string> header = {
      "dataset",  "seed",         "estimator",      "object", "class",         "subtype",
      "stamp_ns", "pixels",       "distance_m",     "cut",    "seen_fraction", "failure",
      "failed",   "chamfer_l1_m", "center_error_m", "v_iou",  "b_iou",         "inlier_ratio"};
  for (const std::string& stage : stages) header.push_back(stage + "_wall_ms");
  std::string csv = csvLine(header);
  for (const SingleViewRow& row : rows) {
    std::vector<std::string> cells = {row.dataset,
                                      row.world_seed,
                                      row.estimator,
                                      row.object,
                                      row.class_name,
                                      row.subtype,
                                      std::to_string(row.stamp_ns),
                                      std::to_string(row.pixels),
                                      csvNumber(row.distance_m),
                                      row.cut ? "1" : "0",
                                      csvNumber(row.seen_fraction),
                                      row.failure,
                                      row.failed() ? "1" : "0",
                                      csvNumber(row.chamfer_l1_m),
                                      csvNumber(row.center_error_m),
                                      csvNumber(row.v_iou),
                                      csvNumber(row.b_iou),
                                      csvNumber(row.inlier_ratio)};
    for (const std::string& stage : stages) {
      const auto found = row.wall_ms.find(stage);
      cells.push_back(found == row.wall_ms.end() ? "" : csvNumber(found->second));
    }
    csv += csvLine(cells);
  }
  return csv;
}

std::string summaryCsv(const std::vector<SingleViewSummary>& summaries) {
  std::vector<std::string> header = {"estimator", "class", "objects"};
  for (const char* name : {"chamfer_l1_m", "center_error_m", "v_iou", "b_iou", "failures"}) {
    for (const char* suffix : {"", "_low", "_high"}) header.push_back(std::string(name) + suffix);
  }
  header.insert(header.end(), {"p50_ms", "p99_ms"});
  std::string csv = csvLine(header);
  for (const SingleViewSummary& s : summaries) {
    std::vector<std::string> cells = {s.estimator, s.class_name, std::to_string(s.objects)};
    for (const SingleViewSummary::Median* m :
         {&s.chamfer_l1_m, &s.center_error_m, &s.v_iou, &s.b_iou, &s.failure_share}) {
      for (const double value : {m->value, m->interval.low, m->interval.high}) {
        cells.push_back(std::isinf(value) ? "inf" : csvNumber(value));
      }
    }
    cells.push_back(csvNumber(s.p50_ms));
    cells.push_back(csvNumber(s.p99_ms));
    csv += csvLine(cells);
  }
  return csv;
}

std::string summaryTable(const std::vector<SingleViewSummary>& summaries) {
  std::size_t widest = 9;
  for (const SingleViewSummary& s : summaries) widest = std::max(widest, s.estimator.size());
  std::string text = fmt::format("{:<{}}  {:<8} {:>4}  {:<18} {:<18} {:<21} {:<21} {:<18} {}\n",
                                 "estimator", widest, "class", "n", "chamfer_l1 [cm]",
                                 "center [cm]", "v_iou", "b_iou", "failures [%]", "p50/p99 [ms]");
  for (const SingleViewSummary& s : summaries) {
    text += fmt::format("{:<{}}  {:<8} {:>4}  {:<18} {:<18} {:<21} {:<21} {:<18} {:.0f}/{:.0f}\n",
                        s.estimator, widest, s.class_name, s.objects, cm(s.chamfer_l1_m),
                        cm(s.center_error_m), share(s.v_iou), share(s.b_iou), cm(s.failure_share),
                        s.p50_ms, s.p99_ms);
  }
  return text;
}

}  // namespace hydrabench

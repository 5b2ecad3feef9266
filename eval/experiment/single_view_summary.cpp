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

SingleViewSummary summaryOf(const std::string& class_name,
                            const std::vector<const SingleViewRow*>& rows,
                            const BootstrapConfig& bootstrap) {
  constexpr double kWorst = std::numeric_limits<double>::infinity();
  SingleViewSummary summary;
  summary.dataset = rows.front()->dataset;
  summary.estimator = rows.front()->estimator;
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
    if (row->failure.empty()) times.push_back(row->wall_ms.at("total"));
  }
  summary.failure_share = resampled(failures, mean, bootstrap);
  if (!times.empty()) {
    summary.p50_ms = quantile(times, 0.5);
    summary.p99_ms = quantile(times, 0.99);
  }
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
  using Group = std::vector<const SingleViewRow*>;
  std::vector<std::pair<std::string, std::string>> places;  // dataset, estimator
  std::map<std::pair<std::string, std::string>, Group> of_place;
  for (const SingleViewRow& row : rows) {
    Group& group = of_place[{row.dataset, row.estimator}];
    if (group.empty()) places.emplace_back(row.dataset, row.estimator);
    group.push_back(&row);
  }
  std::vector<SingleViewSummary> summaries;
  for (const auto& place : places) {
    std::map<std::string, Group> classes;
    Group in_domain, out_of_domain;
    for (const SingleViewRow* row : of_place[place]) {
      classes[row->class_name].push_back(row);
      if (row->in_domain) (*row->in_domain ? in_domain : out_of_domain).push_back(row);
    }
    const auto add = [&](const std::string& name, const Group& group) {
      if (!group.empty()) summaries.push_back(summaryOf(name, group, bootstrap));
    };
    add(kAllClasses, of_place[place]);
    add(kInDomain, in_domain);
    add(kOutOfDomain, out_of_domain);
    for (const auto& [name, group] : classes) add(name, group);
  }
  return summaries;
}

std::string viewsCsv(const std::vector<SingleViewRow>& rows) {
  std::set<std::string> stages;
  for (const SingleViewRow& row : rows) {
    for (const auto& [stage, _] : row.wall_ms) stages.insert(stage);
  }
  std::vector<std::string> header = {"dataset", "seed",       "estimator",    "object",
                                     "class",   "in_domain",  "subtype",      "stamp_ns",
                                     "pixels",  "distance_m", "cut",          "seen_fraction",
                                     "failure", "failed",     "chamfer_l1_m", "center_error_m",
                                     "v_iou",   "b_iou",      "inlier_ratio"};
  for (const std::string& stage : stages) header.push_back(stage + "_wall_ms");
  std::string csv = csvLine(header);
  for (const SingleViewRow& row : rows) {
    std::vector<std::string> cells = {row.dataset,
                                      row.world_seed,
                                      row.estimator,
                                      row.object,
                                      row.class_name,
                                      !row.in_domain   ? ""
                                      : *row.in_domain ? "1"
                                                       : "0",
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
  std::vector<std::string> header = {"dataset", "estimator", "class", "objects"};
  for (const char* name : {"chamfer_l1_m", "center_error_m", "v_iou", "b_iou", "failures"}) {
    for (const char* suffix : {"", "_low", "_high"}) header.push_back(std::string(name) + suffix);
  }
  header.insert(header.end(), {"p50_ms", "p99_ms"});
  std::string csv = csvLine(header);
  for (const SingleViewSummary& s : summaries) {
    std::vector<std::string> cells = {s.dataset, s.estimator, s.class_name,
                                      std::to_string(s.objects)};
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
  std::size_t dataset = 7;
  std::size_t estimator = 9;
  std::size_t class_name = 5;
  for (const SingleViewSummary& s : summaries) {
    dataset = std::max(dataset, s.dataset.size());
    estimator = std::max(estimator, s.estimator.size());
    class_name = std::max(class_name, s.class_name.size());
  }
  constexpr const char* kRow =
      "{:<{}}  {:<{}}  {:<{}} {:>4}  {:<18} {:<18} {:<21} {:<21} {:<18} {}\n";
  std::string text = fmt::format(kRow, "dataset", dataset, "estimator", estimator, "class",
                                 class_name, "n", "chamfer_l1 [cm]", "center [cm]", "v_iou",
                                 "b_iou", "failures [%]", "p50/p99 [ms]");
  for (const SingleViewSummary& s : summaries) {
    const std::string times = s.p50_ms ? fmt::format("{:.0f}/{:.0f}", *s.p50_ms, *s.p99_ms) : "n/a";
    text += fmt::format(kRow, s.dataset, dataset, s.estimator, estimator, s.class_name, class_name,
                        s.objects, cm(s.chamfer_l1_m), cm(s.center_error_m), share(s.v_iou),
                        share(s.b_iou), cm(s.failure_share), times);
  }
  return text;
}

}  // namespace hydrabench

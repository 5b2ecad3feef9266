// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/report/kappa_report.h"

#include <algorithm>
#include <cassert>
#include <functional>
#include <iterator>
#include <set>

#include <fmt/format.h>

#include "core/io/atomic_file.h"
#include "core/parallel/parallel_for.h"
#include "eval/evaluation/csv.h"
#include "eval/report/comparison_table.h"
#include "metrics/bootstrap.h"

namespace hydrabench {
namespace {

constexpr std::size_t kIntervalSamples = 41;

const KappaSweep& pooledSweep(const MethodEvaluation& method, Matching matching) {
  for (const KappaCurve& curve : method.kappa_curves) {
    if (curve.class_name == kAllMicro && curve.sweep.matching == matching) return curve.sweep;
  }
  assert(false);
  return method.kappa_curves.front().sweep;
}

/// Counts at one kappa, each class under a number of its own.
CountsByClass countsAt(const MethodEvaluation& method, Matching matching, double kappa) {
  CountsByClass counts;
  for (const KappaCurve& curve : method.kappa_curves) {
    if (curve.class_name == kAllMicro || curve.sweep.matching != matching) continue;
    counts.emplace(static_cast<Label>(counts.size()), curve.sweep.at(kappa));
  }
  return counts;
}

/// A sample of all three scores with their intervals.
struct Sample {
  double kappa = 0;
  DetectionCounts counts;
  DetectionIntervals intervals;
};
std::vector<Sample> samples(const MethodEvaluation& method, Matching matching, double kappa_max,
                            const EvaluationConfig& config) {
  std::vector<Sample> result;
  for (const KappaSample& at :
       sampled(pooledSweep(method, matching), kappa_max, kIntervalSamples)) {
    result.push_back({at.kappa, at.counts, {}});
  }
  if (config.bootstrap_resamples == 0) return result;
  parallelFor(result.size(), [&](std::size_t i) {
    result[i].intervals = bootstrapDetection(countsAt(method, matching, result[i].kappa),
                                             Averaging::kMicro, config.bootstrapConfig());
  });
  return result;
}

/// Mean of a score over (0, kappa_max], exact; nullopt where it is undefined.
std::optional<double> meanOverKappa(const KappaSweep& sweep, DetectionScore score,
                                    double kappa_max) {
  double area = 0;
  for (std::size_t i = 0; i < sweep.steps.size() && sweep.steps[i].kappa < kappa_max; ++i) {
    const bool last = i + 1 == sweep.steps.size();
    const double end = last ? kappa_max : std::min(sweep.steps[i + 1].kappa, kappa_max);
    const auto height = score(sweep.steps[i].counts);
    if (!height) return std::nullopt;
    area += *height * (end - sweep.steps[i].kappa);
  }
  return area / kappa_max;
}

std::string shown(const std::optional<double>& value) {
  return value ? fmt::format("{:.3f}", *value) : "n/a";
}

/// A dataset may be called anything.
std::string fileName(std::string text) {
  for (char& c : text) {
    const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
    if (!plain && c != '-') c = '_';
  }
  return text;
}

std::string csvText(const std::optional<Interval>& interval, double Interval::*side) {
  return interval ? csvNumber((*interval).*side) : "";
}

}  // namespace

double KappaReport::shareAbove(std::size_t a, std::size_t b) const {
  const KappaSweep& sweep_a = pooledSweep(*methods[a], matching);
  const KappaSweep& sweep_b = pooledSweep(*methods[b], matching);
  std::set<double> ends = {kappa_max};
  for (const KappaSweep* sweep : {&sweep_a, &sweep_b}) {
    for (const KappaSweep::Step& step : sweep->steps) {
      if (step.kappa > 0 && step.kappa < kappa_max) ends.insert(step.kappa);
    }
  }
  double above = 0;
  double begin = 0;
  for (const double end : ends) {
    // Nothing changes within (begin, end].
    if (f1(sweep_a.at(end)).value_or(0) > f1(sweep_b.at(end)).value_or(0)) above += end - begin;
    begin = end;
  }
  return above / kappa_max;
}

std::vector<KappaReport> kappaReports(const std::vector<MethodEvaluation>& evaluations,
                                      double kappa_max) {
  std::set<std::string> with_pool;
  std::vector<std::string> datasets;
  for (const MethodEvaluation& evaluation : evaluations) {
    if (evaluation.seed == kPooledSeed) with_pool.insert(evaluation.dataset);
    if (std::find(datasets.begin(), datasets.end(), evaluation.dataset) == datasets.end()) {
      datasets.push_back(evaluation.dataset);
    }
  }
  std::vector<KappaReport> reports;
  for (const std::string& dataset : datasets) {
    KappaReport report;
    report.dataset = dataset;
    report.kappa_max = kappa_max;
    for (const MethodEvaluation& evaluation : evaluations) {
      if (evaluation.dataset != dataset) continue;
      if (with_pool.contains(dataset) && evaluation.seed != kPooledSeed) continue;
      report.methods.push_back(&evaluation);
    }
    for (const Matching matching : {Matching::kExists, Matching::kOneToOne}) {
      report.matching = matching;
      reports.push_back(report);
    }
  }
  return reports;
}

std::string kappaIntervalsCsv(const std::vector<KappaReport>& reports,
                              const EvaluationConfig& config) {
  std::vector<std::string> header = {"dataset", "seed", "method", "matching", "kappa"};
  for (const NamedDetectionScore& score : kDetectionScores) {
    header.insert(header.end(), {score.name, fmt::format("{}_ci95_low", score.name),
                                 fmt::format("{}_ci95_high", score.name)});
  }
  std::string text = csvLine(header);
  for (const KappaReport& report : reports) {
    for (const MethodEvaluation* method : report.methods) {
      for (const Sample& sample : samples(*method, report.matching, report.kappa_max, config)) {
        std::vector<std::string> cells = {report.dataset, method->seed, method->method,
                                          name(report.matching), csvNumber(sample.kappa)};
        for (const NamedDetectionScore& score : kDetectionScores) {
          const auto& interval = sample.intervals.*score.interval;
          cells.insert(cells.end(),
                       {csvNumber(score.value(sample.counts)), csvText(interval, &Interval::low),
                        csvText(interval, &Interval::high)});
        }
        text += csvLine(cells);
      }
    }
  }
  return text;
}

std::string kappaMarkdown(const std::vector<KappaReport>& reports) {
  std::string text =
      "Thresholds relative to size: an estimate counts within kappa times half the diagonal of the "
      "object. Means over kappa are areas under the curves over the largest kappa.\n";
  for (const KappaReport& report : reports) {
    text += fmt::format("\n### {}, {}, kappa up to {:g}\n\n| method | mean P | mean R | mean F1 |",
                        report.dataset, name(report.matching), report.kappa_max);
    std::string line = "\n|---|---:|---:|---:|";
    for (const MethodEvaluation* other : report.methods) {
      text += fmt::format(" F1 above {} |", methodLabel(other->method));
      line += "---:|";
    }
    text += line + "\n";
    for (std::size_t m = 0; m < report.methods.size(); ++m) {
      const KappaSweep& sweep = pooledSweep(*report.methods[m], report.matching);
      text += fmt::format("| {} |", methodLabel(report.methods[m]->method));
      for (const NamedDetectionScore& score : kDetectionScores) {
        text += fmt::format(" {} |", shown(meanOverKappa(sweep, score.value, report.kappa_max)));
      }
      for (std::size_t other = 0; other < report.methods.size(); ++other) {
        text += m == other ? " |"
                           : fmt::format(" {:.1f} % of kappa |", 100 * report.shareAbove(m, other));
      }
      text += "\n";
    }
  }
  return text;
}

Plot kappaPlot(const KappaReport& report, const EvaluationConfig& config) {
  Plot plot;
  for (const NamedDetectionScore& score : kDetectionScores) {
    PlotPanel& panel = plot.panels.emplace_back();
    panel.x_label = "normalised threshold κ";
    panel.y_label = score.title;
    panel.x_range = {0, report.kappa_max};
  }
  for (const MethodEvaluation* method : report.methods) {
    const KappaSweep& sweep = pooledSweep(*method, report.matching);
    const std::vector<Sample> points = samples(*method, report.matching, report.kappa_max, config);
    for (std::size_t s = 0; s < std::size(kDetectionScores); ++s) {
      const NamedDetectionScore& score = kDetectionScores[s];
      PlotCurve& curve = plot.panels[s].curves.emplace_back();
      curve.label = methodLabel(method->method);
      if (const auto area = meanOverKappa(sweep, f1, report.kappa_max)) {
        curve.label += fmt::format(" (AUC {:.2f})", *area);
      }
      curve.steps = true;
      for (const KappaSweep::Step& step : sweep.steps) {
        const auto value = score.value(step.counts);
        if (value && step.kappa <= report.kappa_max) curve.points.emplace_back(step.kappa, *value);
      }
      for (const Sample& sample : points) {
        if (const auto& interval = sample.intervals.*score.interval) {
          curve.band.push_back({sample.kappa, interval->low, interval->high});
        }
      }
    }
  }
  return plot;
}

std::vector<std::string> writeKappaReport(const std::filesystem::path& folder,
                                          const std::vector<MethodEvaluation>& evaluations,
                                          const EvaluationConfig& config) {
  const std::vector<KappaReport> reports = kappaReports(evaluations, config.kappa_max);
  writeFileAtomic(folder / "kappa_intervals.csv", kappaIntervalsCsv(reports, config));
  writeFileAtomic(folder / "kappa.md", kappaMarkdown(reports));
  std::vector<std::string> remarks;
  for (const KappaReport& report : reports) {
    const std::string remark =
        drawPlot(kappaPlot(report, config), folder / "plots",
                 fmt::format("kappa_{}_{}", fileName(report.dataset), name(report.matching)));
    if (!remark.empty()) remarks.push_back("plots/" + remark);
  }
  return remarks;
}

}  // namespace hydrabench

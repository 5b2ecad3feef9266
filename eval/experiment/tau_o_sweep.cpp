// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/experiment/tau_o_sweep.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <set>

#include <fmt/format.h>

#include "core/config/config_reader.h"
#include "core/graph/candidate_io.h"
#include "core/parallel/parallel_for.h"
#include "eval/evaluation/csv.h"
#include "eval/evaluation/method_scores.h"
#include "eval/experiment/candidate_geometry.h"

namespace hydrabench {
namespace {

/// A world with the geometry of its candidates measured once.
class World {
 public:
  explicit World(const TauOWorld& world)
      : candidates_(world.candidates), counting_(world.counting), geometry_(world.candidates) {}

  std::size_t addMatches(const DecisionConfig& decision, std::vector<TauOStep::At>& scores,
                         std::vector<CountsByClass>& by_class) const {
    const std::vector<DetectionObject> estimates =
        geometry_.estimates(decide(candidates_, decision), counting_);
    for (std::size_t k = 0; k < scores.size(); ++k) {
      const DetectionMatches matches =
          match(scores[k].matching, estimates, counting_.truths, scores[k].threshold);
      scores[k].counts += counts(matches);
      for (const auto& [label, added] : countsByClass(matches, estimates, counting_.truths)) {
        by_class[k][label] += added;
      }
    }
    return estimates.size();
  }

 private:
  const std::vector<ShapeCandidate>& candidates_;
  const Counting& counting_;
  CandidateGeometry geometry_;
};

std::string shown(const std::optional<double>& value) {
  return value ? fmt::format("{:.3f}", *value) : "n/a";
}

}  // namespace

std::vector<TauOStep> sweepTauO(const std::vector<TauOWorld>& worlds,
                                const DecisionConfig& decision, const EvaluationConfig& config) {
  std::set<double> taus = {0};
  std::vector<World> measured;
  for (const TauOWorld& world : worlds) {
    for (const ShapeCandidate& candidate : world.candidates) {
      if (candidate.hasEstimate()) taus.insert(std::clamp(candidate.overlap, 0.0, 1.0));
    }
    measured.emplace_back(world);
  }
  std::vector<TauOStep> steps;
  for (const double tau : taus) {
    TauOStep& step = steps.emplace_back();
    step.tau_o = tau;
    for (const double threshold : config.thresholds_m) {
      for (const Matching matching : {Matching::kExists, Matching::kOneToOne}) {
        step.scores.push_back({Threshold::tau(threshold), matching, {}, {}});
      }
    }
  }
  // Of neighbouring steps many count the same: their intervals are one, and drawn once.
  std::vector<std::vector<CountsByClass>> by_class(steps.size());
  parallelFor(steps.size(), [&](std::size_t i) {
    TauOStep& step = steps[i];
    DecisionConfig at = decision;
    at.rmcc.check = "published";
    at.rmcc.min_overlap = step.tau_o;
    by_class[i].resize(step.scores.size());
    for (const World& world : measured) {
      step.objects += world.addMatches(at, step.scores, by_class[i]);
    }
  });
  if (config.bootstrap_resamples == 0) return steps;
  std::map<CountsByClass, DetectionIntervals> intervals;
  for (const auto& step : by_class) {
    for (const CountsByClass& counts : step) intervals.try_emplace(counts);
  }
  std::vector<decltype(intervals)::pointer> drawn;
  for (auto& entry : intervals) drawn.push_back(&entry);
  parallelFor(drawn.size(), [&](std::size_t i) {
    drawn[i]->second =
        bootstrapDetection(drawn[i]->first, Averaging::kMicro, config.bootstrapConfig());
  });
  for (std::size_t i = 0; i < steps.size(); ++i) {
    for (std::size_t k = 0; k < steps[i].scores.size(); ++k) {
      steps[i].scores[k].ci95 = intervals.at(by_class[i][k]);
    }
  }
  return steps;
}

std::string tauOCsv(const std::vector<TauOStep>& steps) {
  std::vector<std::string> header = {"tau_o",    "tau_o_end",   "threshold_m",
                                     "matching", "estimates",   "matched_estimates",
                                     "truths",   "found_truths"};
  for (const NamedDetectionScore& score : kDetectionScores) {
    for (const char* suffix : {"", "_ci95_low", "_ci95_high"}) {
      header.push_back(std::string(score.name) + suffix);
    }
  }
  std::string text = csvLine(header);
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const double end = i + 1 < steps.size() ? steps[i + 1].tau_o : 1.0;
    for (const TauOStep::At& at : steps[i].scores) {
      std::vector<std::string> cells = {
          csvNumber(steps[i].tau_o),           csvNumber(end),
          csvNumber(at.threshold.value),       name(at.matching),
          std::to_string(at.counts.estimates), std::to_string(at.counts.matched_estimates),
          std::to_string(at.counts.truths),    std::to_string(at.counts.found_truths)};
      for (const NamedDetectionScore& score : kDetectionScores) {
        const auto& interval = at.ci95.*score.interval;
        cells.push_back(csvNumber(score.value(at.counts)));
        cells.push_back(interval ? csvNumber(interval->low) : "");
        cells.push_back(interval ? csvNumber(interval->high) : "");
      }
      text += csvLine(cells);
    }
  }
  return text;
}

Plot tauOPlot(const std::vector<TauOStep>& steps, Matching matching, double used) {
  Plot plot;
  for (std::size_t k = 0; !steps.empty() && k < steps.front().scores.size(); ++k) {
    const TauOStep::At& first = steps.front().scores[k];
    if (first.matching != matching) continue;
    PlotPanel& panel = plot.panels.emplace_back();
    panel.title = fmt::format("within {:g} m", first.threshold.value);
    panel.x_label = "threshold τ of the overlap O";
    panel.y_label = "score";
    panel.marks = {{used, fmt::format("{:g}", used)}};
    for (const NamedDetectionScore& score : kDetectionScores) {
      PlotCurve& curve = panel.curves.emplace_back();
      curve.label = score.title;
      curve.steps = true;
      for (const TauOStep& step : steps) {
        const TauOStep::At& at = step.scores[k];
        if (const auto value = score.value(at.counts)) {
          curve.points.emplace_back(step.tau_o, *value);
        } else if (!curve.end) {
          curve.end = step.tau_o;  // no estimate is left
        }
        if (const auto& interval = at.ci95.*score.interval) {
          if (!curve.band.empty()) {
            curve.band.push_back({step.tau_o, curve.band.back().low, curve.band.back().high});
          }
          curve.band.push_back({step.tau_o, interval->low, interval->high});
        }
      }
    }
  }
  return plot;
}

std::string tauOMarkdown(const std::vector<TauOStep>& steps, double used) {
  std::string text =
      "| tau_d | matching | best F1 | at tau_O | P, R there | F1 at 0 | " +
      fmt::format("F1 at {0:g} | P, R at {0:g} |\n|---|---|---:|---|---|---:|---:|---|\n", used);
  for (std::size_t k = 0; !steps.empty() && k < steps.front().scores.size(); ++k) {
    std::size_t best = 0;
    std::size_t in_use = 0;
    for (std::size_t i = 0; i < steps.size(); ++i) {
      const auto value = [&](std::size_t step) {
        return f1(steps[step].scores[k].counts).value_or(0);
      };
      if (value(i) > value(best)) best = i;
      if (steps[i].tau_o <= used) in_use = i;
    }
    const double end = best + 1 < steps.size() ? steps[best + 1].tau_o : 1.0;
    const auto at = [&](std::size_t step) { return steps[step].scores[k].counts; };
    text += fmt::format("| {:g} m | {} | {} | {:.3f} to {:.3f} | {}, {} | {} | {} | {}, {} |\n",
                        steps[best].scores[k].threshold.value, name(steps[best].scores[k].matching),
                        shown(f1(at(best))), steps[best].tau_o, end, shown(precision(at(best))),
                        shown(recall(at(best))), shown(f1(at(0))), shown(f1(at(in_use))),
                        shown(precision(at(in_use))), shown(recall(at(in_use))));
  }
  return text +
         "\ntau_O was swept after the fact: a threshold chosen by these numbers is tuned on "
         "the test.\n";
}

}  // namespace hydrabench

// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "metrics/kappa_sweep.h"

#include <algorithm>
#include <cassert>
#include <limits>

namespace hydrabench {
namespace {

/// A same-label pair, and the kappa above which it is inside the gate.
struct Edge {
  double kappa = 0;
  std::size_t estimate = 0;
  std::size_t truth = 0;
};

std::vector<Edge> edgesByKappa(std::span<const DetectionObject> estimates,
                               std::span<const DetectionObject> truths) {
  std::vector<Edge> edges;
  for (std::size_t g = 0; g < truths.size(); ++g) {
    if (!(truths[g].half_diagonal > 0)) continue;  // never admitted
    for (std::size_t e = 0; e < estimates.size(); ++e) {
      if (estimates[e].label != truths[g].label || estimates[e].world != truths[g].world) continue;
      const double distance = (estimates[e].center - truths[g].center).norm();
      edges.push_back({distance / truths[g].half_diagonal, e, g});
    }
  }
  std::sort(edges.begin(), edges.end(),
            [](const Edge& a, const Edge& b) { return a.kappa < b.kappa; });
  return edges;
}

/// Partners found so far under `exists`.
class ExistsCounter {
 public:
  ExistsCounter(std::size_t estimates, std::size_t truths)
      : counts_{estimates, 0, truths, 0}, matched_(estimates), found_(truths) {}

  void open(const Edge& edge) {
    counts_.matched_estimates += !matched_[edge.estimate];
    counts_.found_truths += !found_[edge.truth];
    matched_[edge.estimate] = true;
    found_[edge.truth] = true;
  }
  const DetectionCounts& counts() const { return counts_; }

 private:
  DetectionCounts counts_;
  std::vector<bool> matched_;
  std::vector<bool> found_;
};

/// The largest matching of a growing bipartite graph. An edge more lengthens it by at most one
/// pair, along an augmenting path (Berge 1957). Which pairs they are does not matter here: only how
/// many.
class OneToOneCounter {
 public:
  OneToOneCounter(std::size_t estimates, std::size_t truths)
      : counts_{estimates, 0, truths, 0},
        truths_of_(estimates),
        truth_of_(estimates, kFree),
        estimate_of_(truths, kFree) {}

  void open(const Edge& edge) {
    truths_of_[edge.estimate].push_back(edge.truth);
    if (counts_.found_truths == std::min(counts_.estimates, counts_.truths)) return;
    if (!augment()) return;
    ++counts_.matched_estimates;
    ++counts_.found_truths;
  }
  const DetectionCounts& counts() const { return counts_; }

 private:
  static constexpr std::size_t kFree = std::numeric_limits<std::size_t>::max();

  /// Breadth first from all free estimates at once.
  bool augment() {
    std::vector<std::size_t> queue;
    std::vector<std::size_t> reached_from(estimate_of_.size(), kFree);
    for (std::size_t e = 0; e < truth_of_.size(); ++e) {
      if (truth_of_[e] == kFree) queue.push_back(e);
    }
    for (std::size_t next = 0; next < queue.size(); ++next) {
      for (const std::size_t truth : truths_of_[queue[next]]) {
        if (reached_from[truth] != kFree) continue;
        reached_from[truth] = queue[next];
        if (estimate_of_[truth] == kFree) {
          flipPath(truth, reached_from);
          return true;
        }
        queue.push_back(estimate_of_[truth]);
      }
    }
    return false;
  }

  void flipPath(std::size_t truth, const std::vector<std::size_t>& reached_from) {
    while (truth != kFree) {
      const std::size_t estimate = reached_from[truth];
      const std::size_t freed = truth_of_[estimate];
      truth_of_[estimate] = truth;
      estimate_of_[truth] = estimate;
      truth = freed;
    }
  }

  DetectionCounts counts_;
  std::vector<std::vector<std::size_t>> truths_of_;  ///< open edges of each estimate
  std::vector<std::size_t> truth_of_;
  std::vector<std::size_t> estimate_of_;
};

template <typename Counter>
std::vector<KappaSweep::Step> collectSteps(const std::vector<Edge>& edges, Counter counter) {
  std::vector<KappaSweep::Step> steps = {{0.0, counter.counts()}};
  for (const Edge& edge : edges) {
    counter.open(edge);
    if (counter.counts() == steps.back().counts) continue;
    if (edge.kappa == steps.back().kappa) {
      steps.back().counts = counter.counts();
    } else {
      steps.push_back({edge.kappa, counter.counts()});
    }
  }
  return steps;
}

}  // namespace

DetectionCounts KappaSweep::at(double kappa) const {
  assert(!steps.empty());
  const auto above = std::lower_bound(steps.begin(), steps.end(), kappa,
                                      [](const Step& step, double k) { return step.kappa < k; });
  if (above != steps.begin()) return std::prev(above)->counts;
  // At kappa 0 (or below) no gate is open, not even for a pair at distance 0.
  return {steps.front().counts.estimates, 0, steps.front().counts.truths, 0};
}

KappaSweep sweepKappa(std::span<const DetectionObject> estimates,
                      std::span<const DetectionObject> truths, Matching matching) {
  const std::vector<Edge> edges = edgesByKappa(estimates, truths);
  KappaSweep sweep;
  sweep.matching = matching;
  sweep.steps = matching == Matching::kExists
                    ? collectSteps(edges, ExistsCounter(estimates.size(), truths.size()))
                    : collectSteps(edges, OneToOneCounter(estimates.size(), truths.size()));
  return sweep;
}

std::optional<double> areaUnderF1(const KappaSweep& sweep, double kappa_max) {
  assert(!sweep.steps.empty() && kappa_max >= 0);
  double area = 0;
  for (std::size_t i = 0; i < sweep.steps.size() && sweep.steps[i].kappa < kappa_max; ++i) {
    const bool last = i + 1 == sweep.steps.size();
    const double end = last ? kappa_max : std::min(sweep.steps[i + 1].kappa, kappa_max);
    const std::optional<double> height = f1(sweep.steps[i].counts);
    if (!height) return std::nullopt;
    area += *height * (end - sweep.steps[i].kappa);
  }
  if (!f1(sweep.steps.front().counts)) return std::nullopt;
  return area;
}

std::vector<KappaSample> sampled(const KappaSweep& sweep, double kappa_max, std::size_t count) {
  assert(count >= 2);
  std::vector<KappaSample> samples(count);
  for (std::size_t i = 0; i < count; ++i) {
    const double kappa = kappa_max * static_cast<double>(i) / static_cast<double>(count - 1);
    samples[i] = {kappa, sweep.at(kappa)};
  }
  return samples;
}

}  // namespace hydrabench

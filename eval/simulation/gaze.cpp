// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/simulation/gaze.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace hydrabench {
namespace {

constexpr int kBins = 72;
constexpr double kBin_rad = 2 * std::numbers::pi / kBins;
constexpr std::size_t kWindow = 48;  // moments planned at once
constexpr std::size_t kCommit = 12;  // of which the first ones are kept before planning anew
constexpr double kAheadWorth = 6.0;  // looking ahead is worth as much as this many new targets
constexpr double kKnownShare = 0.4;  // an object seen to less than this is looked at first
constexpr double kTurnCost = 1.5;    // per bin

using Scores = std::array<double, kBins>;

int binOf(double angle) {
  const double turns = angle / (2 * std::numbers::pi);
  return static_cast<int>((turns - std::floor(turns)) * kBins) % kBins;
}
double angleOf(int bin) { return (bin + 0.5) * kBin_rad; }

double angleBetween(double a, double b) {
  return std::abs(std::remainder(a - b, 2 * std::numbers::pi));
}

/// What has been looked at so far.
class Memory {
 public:
  explicit Memory(const std::vector<std::size_t>& object_of_target)
      : object_of_target_(object_of_target),
        views_(object_of_target.size(), 0),
        objects_(object_of_target.empty()
                     ? 0
                     : 1 + *std::max_element(object_of_target.begin(), object_of_target.end())) {
    for (const std::size_t object : object_of_target) ++objects_[object].targets;
  }
  void look(std::uint32_t target) {
    if (views_[target]++ == 0) ++objects_[object_of_target_[target]].seen;
  }
  /// Of one more look at a target.
  double worth(std::uint32_t target) const {
    static constexpr std::array<double, 5> kWorth = {1, 0.5, 0.25, 0.1, 0.02};
    const auto& object = objects_[object_of_target_[target]];
    const bool unknown = object.seen < kKnownShare * object.targets;
    return (unknown ? 3 : 1) * kWorth[std::min<std::size_t>(views_[target], kWorth.size() - 1)];
  }

 private:
  struct Object {
    int targets = 0;
    int seen = 0;
  };
  const std::vector<std::size_t>& object_of_target_;
  std::vector<std::uint16_t> views_;
  std::vector<Object> objects_;
};

/// Worth of every heading at one moment.
Scores score(const GazeMoment& moment, const Memory& memory, double half_view) {
  // What lies in each bin, then sums over the bins in view.
  Scores content{};
  for (std::size_t i = 0; i < moment.targets.size(); ++i) {
    content[static_cast<std::size_t>(binOf(moment.bearings_rad[i]))] +=
        memory.worth(moment.targets[i]);
  }
  const int reach = static_cast<int>(half_view / kBin_rad);
  Scores scores{};
  for (int bin = 0; bin < kBins; ++bin) {
    double sum = 0.5 * kAheadWorth * (1 + std::cos(angleOf(bin) - moment.heading_rad));
    for (int k = -reach; k <= reach; ++k)
      sum += content[static_cast<std::size_t>((bin + k + kBins) % kBins)];
    scores[static_cast<std::size_t>(bin)] = sum;
  }
  return scores;
}

/// Best sequence of bins for the scores; the first step starts from `from` (any bin if negative).
std::vector<int> bestSequence(const std::vector<Scores>& scores, int from, int max_turn) {
  std::vector<std::array<int, kBins>> previous(scores.size());
  Scores value{};
  if (from >= 0) {
    value.fill(-1e18);
    value[static_cast<std::size_t>(from)] = 0;
  }
  for (std::size_t step = 0; step < scores.size(); ++step) {
    const bool free = step == 0 && from < 0;
    Scores next{};
    for (int bin = 0; bin < kBins; ++bin) {
      double best = -1e30;
      int best_bin = bin;
      for (int turn = -max_turn; turn <= max_turn; ++turn) {
        if (free && turn != 0) continue;
        const int source = (bin + turn + kBins) % kBins;
        const double total = value[static_cast<std::size_t>(source)] - kTurnCost * std::abs(turn);
        if (total > best) {
          best = total;
          best_bin = source;
        }
      }
      next[static_cast<std::size_t>(bin)] = best + scores[step][static_cast<std::size_t>(bin)];
      previous[step][static_cast<std::size_t>(bin)] = best_bin;
    }
    value = next;
  }
  int bin = static_cast<int>(std::max_element(value.begin(), value.end()) - value.begin());
  std::vector<int> sequence(scores.size());
  for (std::size_t step = scores.size(); step-- > 0;) {
    sequence[step] = bin;
    bin = previous[step][static_cast<std::size_t>(bin)];
  }
  return sequence;
}

}  // namespace

std::vector<double> planGaze(const std::vector<GazeMoment>& moments,
                             const std::vector<std::size_t>& object_of_target,
                             const GazeLimits& limits) {
  const int max_turn = std::max(1, static_cast<int>(limits.max_turn_rad / kBin_rad));
  Memory memory(object_of_target);
  std::vector<double> yaw;
  int last = -1;
  for (std::size_t begin = 0; begin < moments.size(); begin += kCommit) {
    const std::size_t end = std::min(begin + kWindow, moments.size());
    std::vector<Scores> scores;
    for (std::size_t i = begin; i < end; ++i)
      scores.push_back(score(moments[i], memory, limits.half_view_rad));
    const std::vector<int> sequence = bestSequence(scores, last, max_turn);
    for (std::size_t i = begin; i < std::min(begin + kCommit, moments.size()); ++i) {
      last = sequence[i - begin];
      const double angle = angleOf(last);
      yaw.push_back(yaw.empty()
                        ? angle
                        : yaw.back() + std::remainder(angle - yaw.back(), 2 * std::numbers::pi));
      for (std::size_t k = 0; k < moments[i].targets.size(); ++k) {
        if (angleBetween(moments[i].bearings_rad[k], angle) < limits.half_view_rad) {
          memory.look(moments[i].targets[k]);
        }
      }
    }
  }
  return yaw;
}

}  // namespace hydrabench

// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/report/result_comparison.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <set>
#include <span>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "core/geometry/median.h"
#include "core/io/atomic_file.h"
#include "core/types/error.h"
#include "eval/evaluation/method_scores.h"
#include "eval/report/comparison_table.h"
#include "eval/report/objects_csv.h"
#include "eval/report/result_folder.h"
#include "eval/report/significance.h"

namespace hydrabench {
namespace fs = std::filesystem;
namespace {

using Verdict = ResultComparison::Verdict;
using Line = ResultComparison::Line;

/// By dataset and method, the worlds by seed.
using Worlds = std::map<std::string, MethodEvaluation>;
using Methods = std::map<std::pair<std::string, std::string>, Worlds>;

Methods readMethods(const fs::path& result) {
  const fs::path file = result / "objects.csv";
  if (!fs::exists(file)) {
    throw InputError(
        fmt::format("{}: no objects.csv in there, expected a result folder of 'run' "
                    "or 'evaluate'",
                    result.string()));
  }
  Methods methods;
  for (MethodEvaluation& evaluation : readObjectsCsv(file)) {
    std::pair<std::string, std::string> key{evaluation.dataset, evaluation.method};
    methods[std::move(key)].emplace(evaluation.seed, std::move(evaluation));
  }
  return methods;
}

std::vector<double> thresholds(const fs::path& result) {
  std::set<double> values;
  for (const ScoreRow& row : readScoresCsv(result / "scores.csv")) {
    if (row.threshold_kind == "tau_m" && row.threshold) values.insert(*row.threshold);
  }
  return {values.begin(), values.end()};
}

/// @param better  +1 where more is better, -1 where less is
Verdict judge(double low, double high, double floor, int better) {
  if (better < 0) {
    std::swap(low, high);
    low = -low;
    high = -high;
  }
  if (low > 0) return Verdict::kBetter;
  if (high < -floor) return Verdict::kWorse;
  return low < -floor ? Verdict::kInconclusive : Verdict::kSame;
}

/// Fewer tell nothing of what a machine does besides.
constexpr std::size_t kFewestStretches = 8;

/// The cost of the same frames in both results, over stretches of them. Times are taken in units
/// of the yardstick that was timed beside each stretch, so that other work on the machine, then or
/// now, is not taken for the program's. Of a yardstick's times the median counts: threads that wake
/// up late make some of them far too long. Nothing disturbs a count of instructions: there a frame
/// is a stretch.
class Stretches {
 public:
  void addTimed(const FrameTimes& before, const FrameTimes& after) {
    constexpr std::size_t kFrames = 25;
    for (std::size_t begin = 0; begin < before.wall_ms.size(); begin += kFrames) {
      const std::size_t end = std::min(begin + kFrames, before.wall_ms.size());
      const auto wall = [&](const FrameTimes& times) {
        return std::accumulate(&times.wall_ms[begin], &times.wall_ms[begin] + (end - begin), 0.0);
      };
      const auto yardstick = [&](const FrameTimes& times) {
        return median(
            std::vector<double>(times.yardstick_ms.begin() + static_cast<std::ptrdiff_t>(begin),
                                times.yardstick_ms.begin() + static_cast<std::ptrdiff_t>(end)));
      };
      const PairedValue sum{wall(before), wall(after)};
      cost_.push_back(sum);
      const bool measured = !before.yardstick_ms.empty() && !after.yardstick_ms.empty();
      relative_.push_back(
          measured ? PairedValue{sum.a / yardstick(before), sum.b / yardstick(after)} : sum);
    }
    frames_ += before.wall_ms.size();
    timed_ = true;
  }

  void addCounted(const FrameTimes& before, const FrameTimes& after) {
    for (std::size_t i = 0; i < before.instructions.size(); ++i) {
      cost_.push_back({before.instructions[i], after.instructions[i]});
    }
    relative_ = cost_;
    frames_ = cost_.size();
  }

  /// Nothing where there are no frames.
  std::optional<Line> compared(const std::string& metric, const NoiseFloor& floor) const {
    std::vector<std::size_t> all(cost_.size());
    std::iota(all.begin(), all.end(), std::size_t{0});
    const PairedValue total = sum(cost_, all);
    if (total.a <= 0) return std::nullopt;
    BootstrapConfig config;
    config.resamples = floor.resamples;
    // All worlds in one stratum: short ones have but a stretch or two.
    const std::vector<std::size_t> sizes = {cost_.size()};
    const auto change = bootstrapStatistic(
        sizes,
        [&](std::span<const std::size_t> drawn) -> std::optional<double> {
          const PairedValue of_draw = sum(relative_, drawn);
          if (of_draw.a <= 0) return std::nullopt;
          return of_draw.b / of_draw.a - 1;
        },
        config);
    Line line;
    line.metric = metric;
    line.relative = true;
    line.before = total.a / static_cast<double>(frames_);
    line.after = total.b / static_cast<double>(frames_);
    line.low = change->interval.low;
    line.high = change->interval.high;
    // Two runs never take the same time: a little faster is the same, as a little slower is.
    const bool one_run = std::all_of(cost_.begin(), cost_.end(),
                                     [](const PairedValue& cost) { return cost.a == cost.b; });
    if (one_run) {
      line.verdict = Verdict::kSame;
    } else if (timed_ && cost_.size() < kFewestStretches) {
      line.verdict = Verdict::kInconclusive;
    } else if (line.low > floor.time_share / 2) {
      line.verdict = Verdict::kWorse;
    } else if (line.high < -floor.time_share / 2) {
      line.verdict = Verdict::kBetter;
    } else {
      const bool within = line.low >= -floor.time_share && line.high <= floor.time_share;
      line.verdict = within ? Verdict::kSame : Verdict::kInconclusive;
    }
    return line;
  }

 private:
  static PairedValue sum(const std::vector<PairedValue>& values,
                         std::span<const std::size_t> drawn) {
    PairedValue total;
    for (const std::size_t i : drawn) {
      total.a += values[i].a;
      total.b += values[i].b;
    }
    return total;
  }

  std::vector<PairedValue> cost_;      ///< a: before, b: after [ms] or [10^6 instructions]
  std::vector<PairedValue> relative_;  ///< times in units of the yardstick, where both have one
  std::size_t frames_ = 0;
  bool timed_ = false;
};

class Comparer {
 public:
  Comparer(const fs::path& before, const fs::path& after, const NoiseFloor& floor)
      : before_path_(before), after_path_(after), floor_(floor) {}

  ResultComparison run() {
    const Methods before = readMethods(before_path_);
    const Methods after = readMethods(after_path_);
    config_.thresholds_m = thresholds(after_path_);
    config_.bootstrap_resamples = floor_.resamples;
    for (const auto& [key, worlds] : before) {
      const auto other = after.find(key);
      if (other == after.end()) {
        note(fmt::format("{}, {}: only in the first result", key.first, methodLabel(key.second)));
      } else {
        compare(key.first, key.second, worlds, other->second);
      }
    }
    for (const auto& [key, worlds] : after) {
      if (before.contains(key)) continue;
      note(fmt::format("{}, {}: only in the second result", key.first, methodLabel(key.second)));
    }
    if (comparison_.lines.empty()) {
      throw InputError(fmt::format("{} and {}: no method on a world of both, nothing to compare",
                                   before_path_.string(), after_path_.string()));
    }
    if (floor_.compare_times) compareCosts();
    return std::move(comparison_);
  }

 private:
  void note(std::string text) { comparison_.notes.push_back(std::move(text)); }

  void compare(const std::string& dataset, const std::string& method, const Worlds& before,
               const Worlds& after) {
    std::vector<const MethodEvaluation*> a, b;
    for (const auto& [seed, world] : before) {
      const auto other = after.find(seed);
      if (other == after.end()) {
        note(fmt::format("{}, seed {}, {}: only in the first result", dataset, seed,
                         methodLabel(method)));
        continue;
      }
      requireSameTruths(dataset, seed, world, other->second);
      a.push_back(&world);
      b.push_back(&other->second);
    }
    if (a.empty()) return;
    std::vector<MethodEvaluation> pair = {merged(a), merged(b)};
    pair[0].method = kBefore;
    pair[1].method = kAfter;
    for (const PairedDifference& d : pairedDifferences(pair, config_)) {
      const bool first_is_after = d.method_a == kAfter;
      const int sign = first_is_after ? 1 : -1;
      Line line{dataset,
                method,
                fmt::format("{} ({:g} m)", d.metric, d.threshold_m),
                first_is_after ? d.value_b : d.value_a,
                first_is_after ? d.value_a : d.value_b,
                sign * d.comparison.interval.low + 0.0,  // no -0
                sign * d.comparison.interval.high + 0.0};
      if (line.low > line.high) std::swap(line.low, line.high);
      const bool distance = d.metric.starts_with("chamfer");
      line.verdict = judge(line.low, line.high, distance ? floor_.distance_m : floor_.score,
                           distance ? -1 : 1);
      comparison_.lines.push_back(std::move(line));
    }
  }

  void requireSameTruths(const std::string& dataset, const std::string& seed,
                         const MethodEvaluation& a, const MethodEvaluation& b) const {
    const bool same = std::equal(a.truths.begin(), a.truths.end(), b.truths.begin(), b.truths.end(),
                                 [](const ScoredObject& x, const ScoredObject& y) {
                                   return x.detection.id == y.detection.id &&
                                          x.detection.center == y.detection.center;
                                 });
    if (same) return;
    throw InputError(fmt::format(
        "{} and {}: dataset '{}', seed {}: ground truth differs, expected the same worlds",
        before_path_.string(), after_path_.string(), dataset, seed));
  }

  std::string machine(const fs::path& result) const {
    try {
      const auto json = nlohmann::json::parse(readFile(result / kResultMarker));
      return fmt::format("{}, {} cores", json.at("cpu").get<std::string>(),
                         json.at("cores").get<int>());
    } catch (const nlohmann::json::exception&) {
      return "unknown";
    }
  }

  /// Time or instructions per frame, the same frames in both results. Times are drawn in
  /// stretches, because what slows a machine down lasts longer than a frame.
  void compareCosts() {
    const fs::path before_file = before_path_ / kFrameTimesFile;
    const fs::path after_file = after_path_ / kFrameTimesFile;
    if (!fs::exists(before_file) || !fs::exists(after_file)) {
      return note("time: not compared, not both results were timed frame by frame");
    }
    const bool same_machine = machine(before_path_) == machine(after_path_);
    bool timed = false;
    using Key = std::pair<std::string, std::string>;
    std::map<Key, std::map<std::string, FrameTimes>> before;
    for (FrameTimes& times : readFrameTimesCsv(before_file)) {
      before[{times.dataset, times.method}][times.seed] = std::move(times);
    }
    std::map<Key, Stretches> by_time, by_count;
    for (const FrameTimes& times : readFrameTimesCsv(after_file)) {
      const auto known = before.find({times.dataset, times.method});
      if (known == before.end() || !known->second.contains(times.seed)) continue;
      const FrameTimes& earlier = known->second.at(times.seed);
      const auto notCompared = [&](const std::string& why) {
        note(fmt::format("time: {}, seed {}, {}: not compared, {}", times.dataset, times.seed,
                         methodLabel(times.method), why));
      };
      const Key key{times.dataset, times.method};
      if (earlier.isCounted() != times.isCounted()) {
        notCompared("timed in one result, counted in instructions in the other");
      } else if (earlier.numFrames() != times.numFrames()) {
        notCompared(
            fmt::format("{} frames before and {} after", earlier.numFrames(), times.numFrames()));
      } else if (times.isCounted()) {
        by_count[key].addCounted(earlier, times);
      } else if (same_machine) {
        by_time[key].addTimed(earlier, times);
      }
      timed |= !times.isCounted();
    }
    if (timed && !same_machine) {
      note(fmt::format("time: not compared, other machines ({}; {})", machine(before_path_),
                       machine(after_path_)));
    }
    addLines(by_time, "time per frame [ms]");
    addLines(by_count, "10^6 instructions per frame");
  }

  void addLines(const std::map<std::pair<std::string, std::string>, Stretches>& methods,
                const std::string& metric) {
    for (const auto& [key, stretches] : methods) {
      if (auto line = stretches.compared(metric, floor_)) {
        line->dataset = key.first;
        line->method = key.second;
        comparison_.lines.push_back(std::move(*line));
      }
    }
  }

  static constexpr const char* kBefore = "before";
  static constexpr const char* kAfter = "after";
  fs::path before_path_;
  fs::path after_path_;
  NoiseFloor floor_;
  EvaluationConfig config_;
  ResultComparison comparison_;
};

std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : text) {
    switch (c) {
      case '&':
        result += "&amp;";
        break;
      case '<':
        result += "&lt;";
        break;
      case '>':
        result += "&gt;";
        break;
      case '"':
        result += "&quot;";
        break;
      default:
        result += c;
    }
  }
  return result;
}

std::string sentence(const Line& line) {
  return fmt::format("{:.4g} -> {:.4g}, difference [{:+.4f}, {:+.4f}]", line.before, line.after,
                     line.low, line.high);
}

}  // namespace

const char* name(Verdict verdict) {
  switch (verdict) {
    case Verdict::kSame:
      return "same";
    case Verdict::kBetter:
      return "better";
    case Verdict::kWorse:
      return "worse";
    case Verdict::kInconclusive:
      return "inconclusive";
  }
  return "";
}

Verdict ResultComparison::verdict() const {
  const auto any = [&](Verdict verdict) {
    return std::any_of(lines.begin(), lines.end(),
                       [&](const Line& line) { return line.verdict == verdict; });
  };
  for (const Verdict verdict : {Verdict::kWorse, Verdict::kInconclusive, Verdict::kBetter}) {
    if (any(verdict)) return verdict;
  }
  return Verdict::kSame;
}

ResultComparison compareResults(const fs::path& before, const fs::path& after,
                                const NoiseFloor& floor) {
  return Comparer(before, after, floor).run();
}

std::string comparisonMarkdown(const ResultComparison& comparison) {
  std::string text =
      "| dataset | method | metric | before | after | difference, 95 % | verdict |\n"
      "|---|---|---|---:|---:|---|---|\n";
  for (const Line& line : comparison.lines) {
    const std::string difference =
        line.relative ? fmt::format("{:+.1f} to {:+.1f} %", 100 * line.low, 100 * line.high)
                      : fmt::format("{:+.4f} to {:+.4f}", line.low, line.high);
    text += fmt::format("| {} | {} | {} | {:.4g} | {:.4g} | {} | {} |\n", line.dataset,
                        methodLabel(line.method), line.metric, line.before, line.after, difference,
                        name(line.verdict));
  }
  for (const std::string& note : comparison.notes) text += fmt::format("\n- {}", note);
  if (!comparison.notes.empty()) text += "\n";
  return text + fmt::format("\n**{}**\n", name(comparison.verdict()));
}

std::string comparisonJUnit(const ResultComparison& comparison) {
  const auto count = [&](Verdict verdict) {
    return std::count_if(comparison.lines.begin(), comparison.lines.end(),
                         [&](const Line& line) { return line.verdict == verdict; });
  };
  std::string text = fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
      "<testsuite name=\"hydrabench compare\" tests=\"{}\" failures=\"{}\" skipped=\"{}\">\n",
      comparison.lines.size(), count(Verdict::kWorse), count(Verdict::kInconclusive));
  for (const Line& line : comparison.lines) {
    text += fmt::format("  <testcase classname=\"{}.{}\" name=\"{}\">", escaped(line.dataset),
                        escaped(line.method), escaped(line.metric));
    if (line.verdict == Verdict::kWorse) {
      text += fmt::format("<failure message=\"{}\"/>", escaped(sentence(line)));
    } else if (line.verdict == Verdict::kInconclusive) {
      text += fmt::format("<skipped message=\"{}\"/>", escaped(sentence(line)));
    } else {
      text += fmt::format("<system-out>{}</system-out>", escaped(sentence(line)));
    }
    text += "</testcase>\n";
  }
  return text + "</testsuite>\n";
}

}  // namespace hydrabench

// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/claims/verdict.h"

#include <algorithm>
#include <map>
#include <utility>

#include <fmt/format.h>

#include "core/parallel/parallel_for.h"
#include "eval/claims/size_trend.h"
#include "eval/report/comparison_table.h"
#include "eval/report/matched_method.h"

namespace hydrabench {
namespace {

constexpr int kKappas = 40;

const NamedDetectionScore* detectionScore(const std::string& metric) {
  for (const NamedDetectionScore& score : kDetectionScores) {
    if (metric == score.name) return &score;
  }
  return nullptr;
}

/// @param interval  of a difference in favour of the claim where positive
ClaimVerdict verdictOf(const Predicate& predicate, const Interval& interval) {
  if (predicate.strictly) {
    if (interval.low > predicate.margin) return ClaimVerdict::kHolds;
    return interval.high <= predicate.margin ? ClaimVerdict::kFails : ClaimVerdict::kUndecided;
  }
  if (interval.low >= -predicate.margin) return ClaimVerdict::kHolds;
  return interval.high < -predicate.margin ? ClaimVerdict::kFails : ClaimVerdict::kUndecided;
}

Finding notRun(const Evidence& evidence, std::string why) {
  Finding finding;
  finding.result = evidence.result;
  finding.dataset = evidence.dataset;
  finding.what = std::move(why);
  return finding;
}

/// What verdictOf() asks for, for the reader.
void setBound(const Predicate& predicate, Finding& finding) {
  finding.relation = predicate.strictly ? ">" : ">=";
  finding.bound = predicate.strictly ? predicate.margin : -predicate.margin + 0.0;  // no -0
}

Finding found(const Evidence& evidence, const Predicate& predicate,
              const std::optional<PairedComparison>& comparison, double sign, std::string what) {
  Finding finding = notRun(evidence, std::move(what));
  if (!comparison) {
    finding.verdict = ClaimVerdict::kUndecided;
    finding.what += ": undefined here";
    return finding;
  }
  finding.difference = sign * comparison->difference + 0.0;  // no -0
  finding.interval = {sign * comparison->interval.low + 0.0,
                      sign * comparison->interval.high + 0.0};
  if (sign < 0) std::swap(finding.interval->low, finding.interval->high);
  setBound(predicate, finding);
  finding.verdict = verdictOf(predicate, *finding.interval);
  return finding;
}

/// Fewer objects than this and what they share by chance looks like certainty.
constexpr std::size_t kFewestFound = 8;

std::size_t numFound(const MatchedMethod& method) { return counts(method.matches).found_truths; }

/// A comparison of what was found is open where hardly anything was.
Finding openWhereFewFound(Finding finding, std::size_t found_objects) {
  if (found_objects < kFewestFound &&
      (finding.verdict == ClaimVerdict::kHolds || finding.verdict == ClaimVerdict::kFails)) {
    finding.verdict = ClaimVerdict::kUndecided;
    finding.what += fmt::format(": only {} found", found_objects);
  }
  return finding;
}

std::string shown(const std::optional<double>& value) {
  return value ? fmt::format("{:.3g}", *value) : "n/a";
}
std::string shownScore(const std::optional<double>& value) {
  return value ? fmt::format("{:.3f}", *value) : "n/a";
}

/// Whether the result knows scores of the pairs at this threshold.
bool hasScores(const MatchedMethod& method) {
  for (std::size_t t = 0; t < method.evaluation->truths.size(); ++t) {
    if (method.found(t) && !method.scores(t)) return false;
  }
  return true;
}

class Judge {
 public:
  Judge(const Claim& claim, const std::vector<Evidence>& evidence, const BootstrapConfig& config)
      : claim_(claim), evidence_(evidence), config_(config) {}

  JudgedClaim run() {
    JudgedClaim judged;
    judged.claim = claim_;
    judged.verdict = ClaimVerdict::kHolds;
    for (const Predicate& predicate : claim_.needs) {
      for (const Evidence& evidence : evidence_) {
        if (concerns(predicate, evidence)) look(predicate, evidence, judged.findings);
      }
      for (const std::string& absent : nowhere(predicate)) {
        Finding finding;
        finding.what = absent;
        judged.findings.push_back(std::move(finding));
      }
    }
    for (const ClaimVerdict verdict :
         {ClaimVerdict::kUndecided, ClaimVerdict::kNotRun, ClaimVerdict::kFails}) {
      if (std::any_of(judged.findings.begin(), judged.findings.end(),
                      [&](const Finding& finding) { return finding.verdict == verdict; })) {
        judged.verdict = verdict;
      }
    }
    return judged;
  }

 private:
  bool concerns(const Predicate& predicate, const Evidence& evidence) const {
    return (claim_.dataset.empty() || evidence.dataset == claim_.dataset) &&
           evidence.has(predicate.method);
  }

  /// What no result has: the method, or the method beside one of the others.
  std::vector<std::string> nowhere(const Predicate& predicate) const {
    const std::string place =
        claim_.dataset.empty() ? "" : fmt::format(" on dataset '{}'", claim_.dataset);
    const auto anywhere = [&](const std::string& other) {
      return std::any_of(evidence_.begin(), evidence_.end(), [&](const Evidence& evidence) {
        return concerns(predicate, evidence) && (other.empty() || evidence.has(other));
      });
    };
    std::vector<std::string> absent;
    if (predicate.than.empty() && !anywhere("")) {
      absent.push_back("no result with " + methodLabel(predicate.method) + place);
    }
    for (const std::string& other : predicate.than) {
      if (anywhere(other)) continue;
      absent.push_back(fmt::format("no result with {} and {}{}", methodLabel(predicate.method),
                                   methodLabel(other), place));
    }
    return absent;
  }

  void look(const Predicate& predicate, const Evidence& evidence,
            std::vector<Finding>& findings) const {
    if (predicate.type == Predicate::Type::kRealTime) {
      findings.push_back(realTime(predicate, evidence));
      return;
    }
    if (predicate.type == Predicate::Type::kScene) {
      for (const std::string& other : predicate.than) {
        if (evidence.has(other)) findings.push_back(scene(predicate, evidence, other));
      }
      return;
    }
    const auto method = evidence.methods.find(predicate.method);
    if (method == evidence.methods.end()) {
      findings.push_back(
          notRun(evidence, fmt::format("{} is not on every world", methodLabel(predicate.method))));
      return;
    }
    if (predicate.type == Predicate::Type::kTrend && predicate.than.empty()) {
      findings.push_back(trend(predicate, evidence, method->second, nullptr));
    }
    for (const std::string& name : predicate.than) {
      if (!evidence.has(name)) continue;  // another result may have it; run() looks
      const auto other = evidence.methods.find(name);
      if (other == evidence.methods.end() || !sameTruths(method->second, other->second)) {
        findings.push_back(
            notRun(evidence, fmt::format("{} is not on every world", methodLabel(name))));
      } else if (predicate.type == Predicate::Type::kTrend) {
        findings.push_back(trend(predicate, evidence, method->second, &other->second));
      } else if (predicate.type == Predicate::Type::kKappa) {
        findings.push_back(overKappa(predicate, evidence, method->second, other->second));
      } else {
        findings.push_back(score(predicate, evidence, method->second, other->second));
      }
    }
  }

  Finding score(const Predicate& predicate, const Evidence& evidence, const MethodEvaluation& mine,
                const MethodEvaluation& other) const {
    const Threshold threshold = Threshold::tau(predicate.tau_m);
    const MatchedMethod a = matchedMethod(mine, threshold, predicate.matching);
    const MatchedMethod b = matchedMethod(other, threshold, predicate.matching);
    const auto sentence = [&](const std::string& title, const std::string& of_a,
                              const std::string& of_b) {
      return fmt::format("{} at {:g} m, {}: {} {}, {} {}", title, predicate.tau_m,
                         name(predicate.matching), methodLabel(mine.method), of_a,
                         methodLabel(other.method), of_b);
    };
    if (const NamedDetectionScore* named = detectionScore(predicate.metric)) {
      return found(evidence, predicate, compareDetection(a, b, named->value, config_), 1,
                   sentence(named->title, shownScore(a.score(named->value)),
                            shownScore(b.score(named->value))));
    }
    if (!hasScores(a) || !hasScores(b)) return notRun(evidence, noScores(predicate));
    const PairScoreColumn& column = *findPairScoreColumn(predicate.metric);
    const double sign = column.direction == ScoreDirection::kLowerIsBetter ? -1 : 1;
    return openWhereFewFound(
        found(evidence, predicate, compareFound(a, b, column, config_), sign,
              sentence(predicate.metric + " of the found", shown(meanOfFound(a, column)),
                       shown(meanOfFound(b, column)))),
        std::min(numFound(a), numFound(b)));
  }

  static std::string noScores(const Predicate& predicate) {
    return fmt::format("{} at {:g} m: the result has no scores at this threshold", predicate.metric,
                       predicate.tau_m);
  }

  Finding overKappa(const Predicate& predicate, const Evidence& evidence,
                    const MethodEvaluation& mine, const MethodEvaluation& other) const {
    const NamedDetectionScore& named = *detectionScore(predicate.metric);
    std::vector<Finding> at(kKappas);
    parallelFor(at.size(), [&](std::size_t i) {
      const double kappa = predicate.kappa_max * static_cast<double>(i + 1) / kKappas;
      const MatchedMethod a = matchedMethod(mine, Threshold::kappa(kappa), predicate.matching);
      const MatchedMethod b = matchedMethod(other, Threshold::kappa(kappa), predicate.matching);
      at[i] = found(evidence, predicate, compareDetection(a, b, named.value, config_), 1,
                    fmt::format("kappa {:.3g}", kappa));
    });
    std::erase_if(at, [](const Finding& finding) {
      return finding.interval && *finding.interval == Interval{};
    });
    const std::string title =
        fmt::format("{} over kappa up to {:g}, {}: {} against {}", named.title, predicate.kappa_max,
                    name(predicate.matching), methodLabel(mine.method), methodLabel(other.method));
    if (at.empty()) {
      Finding finding = notRun(evidence, title + ": the same at every kappa");
      finding.difference = 0;
      finding.interval = Interval{};
      finding.verdict = verdictOf(predicate, Interval{});
      setBound(predicate, finding);
      return finding;
    }
    const auto count = [&](ClaimVerdict verdict) {
      return std::count_if(at.begin(), at.end(),
                           [&](const Finding& finding) { return finding.verdict == verdict; });
    };
    // The kappa that speaks most against the claim stands for all.
    Finding worst = *std::min_element(at.begin(), at.end(), [](const Finding& x, const Finding& y) {
      return x.interval.value_or(Interval{}).low < y.interval.value_or(Interval{}).low;
    });
    worst.verdict = count(ClaimVerdict::kFails) > 0       ? ClaimVerdict::kFails
                    : count(ClaimVerdict::kUndecided) > 0 ? ClaimVerdict::kUndecided
                                                          : ClaimVerdict::kHolds;
    worst.what = fmt::format("{}: holds at {}, fails at {}, undecided at {} of {}; least at {}",
                             title, count(ClaimVerdict::kHolds), count(ClaimVerdict::kFails),
                             count(ClaimVerdict::kUndecided), at.size(), worst.what);
    return worst;
  }

  Finding trend(const Predicate& predicate, const Evidence& evidence, const MethodEvaluation& mine,
                const MethodEvaluation* other) const {
    const Threshold threshold = Threshold::tau(predicate.tau_m);
    const PairScoreColumn& column = *findPairScoreColumn(predicate.metric);
    const MatchedMethod a = matchedMethod(mine, threshold, Matching::kOneToOne);
    std::optional<MatchedMethod> b;
    if (other) b = matchedMethod(*other, threshold, Matching::kOneToOne);
    if (!hasScores(a) || (b && !hasScores(*b))) return notRun(evidence, noScores(predicate));
    std::string what =
        fmt::format("{} at {:g} m, slope over |ln(size / size usual in its class)|: {}",
                    predicate.metric, predicate.tau_m, methodLabel(mine.method));
    if (b) what += " less " + methodLabel(other->method);
    return openWhereFewFound(
        found(evidence, predicate, sizeTrend(a, b ? &*b : nullptr, column, config_), 1,
              std::move(what)),
        b ? std::min(numFound(a), numFound(*b)) : numFound(a));
  }

  static Finding realTime(const Predicate& predicate, const Evidence& evidence) {
    std::map<std::string, double> busy_ms;
    std::map<std::string, std::size_t> frames;
    for (const TimingRow& row : evidence.timing) {
      if (row.method != predicate.method) continue;
      if (row.stage != "frame" && row.stage != "finish") continue;
      busy_ms[row.seed] += static_cast<double>(row.n) * row.mean_ms;
      if (row.stage == "frame") frames[row.seed] += row.n;
    }
    std::vector<double> factors;
    for (const auto& [seed, count] : frames) {
      factors.push_back(static_cast<double>(count) * 1e3 / predicate.at_hz / busy_ms[seed]);
    }
    if (factors.empty()) {
      return notRun(evidence, methodLabel(predicate.method) + " was not timed");
    }
    const auto [least, most] = std::minmax_element(factors.begin(), factors.end());
    Finding finding = notRun(
        evidence, fmt::format("{} on {} world{} of frames at {:g} Hz: {:.3g} to {:.3g} times real "
                              "time",
                              methodLabel(predicate.method), factors.size(),
                              factors.size() == 1 ? "" : "s", predicate.at_hz, *least, *most));
    finding.interval = Interval{*least, *most};
    finding.relation = predicate.keeps ? ">=" : "<";
    finding.bound = 1;
    const bool all_keep = *least >= 1;
    const bool none_keeps = *most < 1;
    finding.verdict = all_keep == none_keeps        ? ClaimVerdict::kUndecided
                      : all_keep == predicate.keeps ? ClaimVerdict::kHolds
                                                    : ClaimVerdict::kFails;
    return finding;
  }

  static Finding scene(const Predicate& predicate, const Evidence& evidence,
                       const std::string& other) {
    // Scores of the whole scene have one row per method and world, and one for all worlds.
    const auto rows_of = [&](const std::string& method) {
      std::vector<const ScoreRow*> rows;
      for (const ScoreRow& row : evidence.scores) {
        if (row.method == method && row.metric == predicate.metric) rows.push_back(&row);
      }
      const auto pooled = [](const ScoreRow* row) { return row->seed == kPooledSeed; };
      if (std::any_of(rows.begin(), rows.end(), pooled)) {
        std::erase_if(rows, [&](const ScoreRow* row) { return !pooled(row); });
      }
      return rows;
    };
    for (const std::string& method : {predicate.method, other}) {
      const auto rows = rows_of(method);
      if (rows.size() != 1 || !rows.front()->value) {
        return notRun(evidence, fmt::format("{} of {}: {} rows, expected one with a value",
                                            predicate.metric, methodLabel(method), rows.size()));
      }
    }
    const ScoreRow* a = rows_of(predicate.method).front();
    const ScoreRow* b = rows_of(other).front();
    const std::string what =
        fmt::format("{}: {} {}, {} {}", predicate.metric, methodLabel(predicate.method),
                    shown(a->value), methodLabel(other), shown(b->value));
    if (!a->ci95_low || !a->ci95_high || !b->ci95_low || !b->ci95_high) {
      Finding finding = notRun(evidence, what + ", without intervals");
      finding.verdict = ClaimVerdict::kUndecided;
      return finding;
    }
    PairedComparison comparison;
    comparison.difference = *a->value - *b->value;
    comparison.interval = {*a->ci95_low - *b->ci95_high, *a->ci95_high - *b->ci95_low};
    return found(evidence, predicate, comparison, predicate.lower_is_better ? -1 : 1, what);
  }

  const Claim& claim_;
  const std::vector<Evidence>& evidence_;
  const BootstrapConfig& config_;
};

}  // namespace

const char* name(ClaimVerdict verdict) {
  switch (verdict) {
    case ClaimVerdict::kHolds:
      return "holds";
    case ClaimVerdict::kFails:
      return "fails";
    case ClaimVerdict::kUndecided:
      return "undecided";
    case ClaimVerdict::kNotRun:
      return "not run";
  }
  return "";
}

std::vector<JudgedClaim> judge(const std::vector<Claim>& claims,
                               const std::vector<Evidence>& evidence,
                               const BootstrapConfig& config) {
  std::vector<JudgedClaim> judged;
  for (const Claim& claim : claims) judged.push_back(Judge(claim, evidence, config).run());
  return judged;
}

}  // namespace hydrabench

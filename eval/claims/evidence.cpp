// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/claims/evidence.h"

#include <algorithm>
#include <set>
#include <utility>

#include <fmt/format.h>

#include "core/types/error.h"
#include "eval/evaluation/method_scores.h"
#include "eval/report/objects_csv.h"

namespace hydrabench {
namespace fs = std::filesystem;
namespace {

/// The datasets of a result in order of appearance.
class Collector {
 public:
  explicit Collector(std::string result) : result_(std::move(result)) {}

  Evidence& of(const std::string& dataset) {
    const auto known = std::find_if(all_.begin(), all_.end(),
                                    [&](const Evidence& e) { return e.dataset == dataset; });
    if (known != all_.end()) return *known;
    Evidence& evidence = all_.emplace_back();
    evidence.result = result_;
    evidence.dataset = dataset;
    return evidence;
  }
  std::vector<Evidence> take() { return std::move(all_); }

 private:
  std::string result_;
  std::vector<Evidence> all_;
};

void collectObjects(const fs::path& file, Collector& collector) {
  const std::vector<MethodEvaluation> evaluations = readObjectsCsv(file);
  std::map<std::string, std::set<std::string>> seeds;
  std::map<std::string, std::map<std::string, std::vector<const MethodEvaluation*>>> methods;
  for (const MethodEvaluation& evaluation : evaluations) {
    seeds[evaluation.dataset].insert(evaluation.seed);
    methods[evaluation.dataset][evaluation.method].push_back(&evaluation);
  }
  for (auto& [dataset, of_dataset] : methods) {
    Evidence& evidence = collector.of(dataset);
    evidence.num_worlds = seeds[dataset].size();
    for (auto& [method, worlds] : of_dataset) {
      if (worlds.size() != evidence.num_worlds) continue;
      // Truths are paired by their place: every method lists the worlds in one order.
      std::sort(worlds.begin(), worlds.end(),
                [](const auto* a, const auto* b) { return a->seed < b->seed; });
      evidence.methods.emplace(method, merged(worlds));
    }
  }
}

std::vector<ScoreRow> pooledOnes(std::vector<ScoreRow> rows) {
  const bool has_pool = std::any_of(rows.begin(), rows.end(),
                                    [](const ScoreRow& row) { return row.seed == kPooledSeed; });
  if (has_pool) {
    std::erase_if(rows, [](const ScoreRow& row) { return row.seed != kPooledSeed; });
  }
  return rows;
}

}  // namespace

bool Evidence::has(const std::string& method) const {
  const auto is_of = [&](const auto& row) { return row.method == method; };
  return methods.contains(method) || std::any_of(timing.begin(), timing.end(), is_of) ||
         std::any_of(scores.begin(), scores.end(), is_of);
}

std::vector<Evidence> readEvidence(const std::vector<fs::path>& results) {
  std::vector<Evidence> all;
  for (const fs::path& result : results) {
    if (!fs::exists(result / "scores.csv")) {
      throw InputError(
          fmt::format("{}: no scores.csv in there, expected a result folder of 'run' or 'evaluate'",
                      result.string()));
    }
    Collector collector(result.string());
    for (ScoreRow& row : readScoresCsv(result / "scores.csv")) {
      Evidence& evidence = collector.of(row.dataset);
      evidence.scores.push_back(std::move(row));
    }
    if (fs::exists(result / "objects.csv")) collectObjects(result / "objects.csv", collector);
    if (fs::exists(result / "timing.csv")) {
      for (TimingRow& row : readTimingCsv(result / "timing.csv")) {
        Evidence& evidence = collector.of(row.dataset);
        evidence.timing.push_back(std::move(row));
      }
    }
    for (Evidence& evidence : collector.take()) {
      evidence.scores = pooledOnes(std::move(evidence.scores));
      all.push_back(std::move(evidence));
    }
  }
  return all;
}

}  // namespace hydrabench

// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/evaluation/self_test_check.h"

#include <fmt/format.h>

namespace hydrabench {

std::string wrongRows(const MethodEvaluation& evaluation, const std::string& metric,
                      const std::string& matching, std::optional<double> expected,
                      std::optional<double> tau_m) {
  std::size_t wrong = 0;
  std::size_t total = 0;
  std::string example;
  for (const ScoreRow& row : evaluation.scores) {
    if (row.metric != metric || (!matching.empty() && row.matching != matching)) continue;
    if (tau_m && (row.threshold_kind != name(Threshold::Kind::kTauM) || row.threshold != tau_m)) {
      continue;
    }
    ++total;
    if (row.value == expected) continue;
    if (wrong++ == 0) {
      example =
          fmt::format("{} {} at {} {}: {}", row.matching, row.class_name, row.threshold_kind,
                      row.threshold.value_or(0), row.value ? fmt::format("{}", *row.value) : "n/a");
    }
  }
  if (total == 0) return fmt::format("{}: no rows", metric);
  return wrong == 0
             ? ""
             : fmt::format("{}: {} of {} rows differ, e.g. {}", metric, wrong, total, example);
}

}  // namespace hydrabench

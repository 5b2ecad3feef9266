// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "eval/evaluation/evaluator.h"
#include "eval/report/plot.h"

namespace hydrabench {

/// P, R and F1 over kappa, the size-relative threshold, on one dataset: all methods, all classes
/// pooled, one matching semantics.
struct KappaReport {
  std::string dataset;
  Matching matching = Matching::kExists;
  double kappa_max = 1;
  std::vector<const MethodEvaluation*> methods;  ///< pooled over worlds where there are several

  /// Share of (0, kappa_max] on which the F1 of method a is above that of b. Exact.
  double shareAbove(std::size_t a, std::size_t b) const;
};

/// One report per dataset and matching, in order of appearance. They refer to `evaluations`.
std::vector<KappaReport> kappaReports(const std::vector<MethodEvaluation>& evaluations,
                                      double kappa_max);

/// 95 % bootstrap intervals at 41 kappas as CSV: dataset, seed, method, matching, kappa and each
/// score with its limits. The exact steps are in kappa.csv.
std::string kappaIntervalsCsv(const std::vector<KappaReport>& reports,
                              const EvaluationConfig& config);
/// Means over kappa (area under the curve over kappa_max), and who is above whom where.
std::string kappaMarkdown(const std::vector<KappaReport>& reports);
Plot kappaPlot(const KappaReport& report, const EvaluationConfig& config);

/// Writes kappa_intervals.csv, kappa.md and plots/kappa_DATASET_MATCHING.{gp,png,svg}. Returns what
/// could not be drawn, a line each.
std::vector<std::string> writeKappaReport(const std::filesystem::path& folder,
                                          const std::vector<MethodEvaluation>& evaluations,
                                          const EvaluationConfig& config);

}  // namespace hydrabench

// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/io/atomic_file.h"
#include "eval/evaluation/evaluator.h"
#include "eval/experiment/frame_times.h"
#include "eval/experiment/provenance.h"
#include "eval/experiment/timing.h"
#include "eval/report/comparison_table.h"
#include "eval/report/significance.h"

namespace hydrabench {

/// What evaluate and run write: any number of methods on any number of worlds.
struct Result {
  std::vector<MethodEvaluation> evaluations;  ///< one per dataset, seed and method; pooled ones too
  std::vector<PairedDifference> differences;  ///< between the methods; pairedDifferences()
  std::vector<TimingRow> timing;              ///< empty where nothing was mapped
  std::vector<FrameTimes> frame_times;        ///< the same
  std::vector<std::string> notes;             ///< on the methods, for the table
  std::string config;                         ///< resolved YAML
  EvaluationConfig evaluation;                ///< with which the evaluations were made
  Provenance provenance;
};

/// A result folder can be replaced by another: it is known by this file.
inline constexpr const char* kResultMarker = "provenance.json";

/// Writes scores.csv, objects.csv, variants.csv, significance.*, strata.*, kappa*, table.*, plots,
/// timing.csv, frame_times.csv, notes.txt, config.yaml and provenance.json (docs/metrics.md; each
/// where there is something to write) and commits the folder. Claim it before the work: what cannot
/// be written should be known first. Returns what is missing, a line each: plots need gnuplot.
std::vector<std::string> writeResult(AtomicFolder& folder, const Result& result);

/// table.md, table.tex, table.csv and table.json.
void writeTable(const std::filesystem::path& folder, const ComparisonTable& table);

/// With a row for the rank stability of every method.
std::vector<ScoreRow> allScores(const Result& result);
/// The notes of a result folder; empty where it has none.
std::vector<std::string> readNotes(const std::filesystem::path& folder);
std::string kappaCsv(const Result& result);  ///< the exact steps of the sweep

}  // namespace hydrabench

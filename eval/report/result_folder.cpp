// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/report/result_folder.h"

#include <sstream>

#include <fmt/format.h>

#include "eval/evaluation/csv.h"
#include "eval/report/kappa_report.h"
#include "eval/report/objects_csv.h"
#include "eval/report/variant_table.h"

namespace hydrabench {
namespace {

constexpr const char* kNotesFile = "notes.txt";

}  // namespace

std::vector<std::string> readNotes(const std::filesystem::path& folder) {
  std::vector<std::string> notes;
  if (!std::filesystem::exists(folder / kNotesFile)) return notes;
  std::istringstream lines(readFile(folder / kNotesFile));
  for (std::string line; std::getline(lines, line);) notes.push_back(line);
  return notes;
}

std::vector<ScoreRow> allScores(const Result& result) {
  std::vector<ScoreRow> rows;
  for (const MethodEvaluation& method : result.evaluations) {
    rows.insert(rows.end(), method.scores.begin(), method.scores.end());
  }
  const std::vector<ScoreRow> stability = rankStabilityRows(result.differences);
  rows.insert(rows.end(), stability.begin(), stability.end());
  return rows;
}

std::string kappaCsv(const Result& result) {
  std::string text =
      csvLine({"dataset", "seed", "method", "class", "matching", "kappa", "estimates",
               "matched_estimates", "truths", "found_truths", "precision", "recall", "f1"});
  for (const MethodEvaluation& method : result.evaluations) {
    for (const KappaCurve& curve : method.kappa_curves) {
      for (const KappaSweep::Step& step : curve.sweep.steps) {
        const DetectionCounts& counts = step.counts;
        text += csvLine({method.dataset, method.seed, method.method, curve.class_name,
                         name(curve.sweep.matching), csvNumber(step.kappa),
                         std::to_string(counts.estimates), std::to_string(counts.matched_estimates),
                         std::to_string(counts.truths), std::to_string(counts.found_truths),
                         csvNumber(precision(counts)), csvNumber(recall(counts)),
                         csvNumber(f1(counts))});
      }
    }
  }
  return text;
}

void writeTable(const std::filesystem::path& folder, const ComparisonTable& table) {
  writeFileAtomic(folder / "table.md", renderMarkdown(table));
  writeFileAtomic(folder / "table.tex", renderLatex(table));
  writeFileAtomic(folder / "table.csv", renderCsv(table));
  writeFileAtomic(folder / "table.json", renderJson(table));
}

std::vector<std::string> writeResult(AtomicFolder& folder, const Result& result) {
  const std::filesystem::path& out = folder.temporary();
  std::vector<std::string> remarks;
  if (!result.evaluations.empty()) {
    const std::vector<ScoreRow> scores = allScores(result);
    const ComparisonTable table = comparisonTable(scores, kAllMicro, result.notes);
    writeFileAtomic(out / "scores.csv", scoresCsv(scores));
    writeFileAtomic(out / "objects.csv", objectsCsv(result.evaluations));
    writeFileAtomic(out / "variants.csv",
                    renderVariantsCsv(variantRows(result.evaluations, result.evaluation)));
    if (!result.differences.empty()) {
      writeFileAtomic(out / "significance.csv", significanceCsv(result.differences));
      writeFileAtomic(out / "significance.md", significanceMarkdown(result.differences));
    }
    const std::vector<Stratum> by_visibility = strata(result.evaluations, result.evaluation);
    writeFileAtomic(out / "strata.csv", strataCsv(by_visibility));
    writeFileAtomic(out / "strata.md", strataMarkdown(by_visibility));
    writeFileAtomic(out / "kappa.csv", kappaCsv(result));
    remarks = writeKappaReport(out, result.evaluations, result.evaluation);
    writeTable(out, table);
  }
  if (!result.timing.empty()) writeFileAtomic(out / "timing.csv", timingCsv(result.timing));
  if (!result.frame_times.empty()) {
    writeFileAtomic(out / kFrameTimesFile, frameTimesCsv(result.frame_times));
  }
  if (!result.notes.empty()) {
    writeFileAtomic(out / kNotesFile, fmt::format("{}\n", fmt::join(result.notes, "\n")));
  }
  writeFileAtomic(out / "config.yaml", result.config);
  writeFileAtomic(out / "provenance.json", provenanceJson(result.provenance));
  folder.commit();
  return remarks;
}

}  // namespace hydrabench

// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/report/result_folder.h"

#include <sstream>

#include <fmt/format.h>

#include "eval/evaluation/csv.h"
#include "eval/report/comparison_table.h"
#include "eval/report/kappa_report.h"
#include "eval/report/variant_table.h"

namespace hydrabench {
namespace {

constexpr const char* kNotesFile = "notes.txt";

const char* name(ObjectRow::Outcome outcome) {
  switch (outcome) {
    case ObjectRow::Outcome::kMatched:
      return "matched";
    case ObjectRow::Outcome::kDuplicate:
      return "duplicate";
    case ObjectRow::Outcome::kUnmatched:
      return "unmatched";
    case ObjectRow::Outcome::kMissed:
      return "missed";
  }
  return "";
}

/// Id, centre, half diagonal, face count and whether the mesh is watertight; empty cells for an
/// absent object.
void appendObject(const ScoredObject* object, std::vector<std::string>& cells) {
  if (!object) {
    cells.insert(cells.end(), 7, "");
    return;
  }
  cells.push_back(std::to_string(object->detection.id));
  for (const double coordinate : object->detection.center) cells.push_back(csvNumber(coordinate));
  cells.push_back(csvNumber(object->detection.half_diagonal));
  cells.push_back(std::to_string(object->faces));
  cells.push_back(object->watertight ? "yes" : "no");
}

std::vector<std::string> objectColumns() {
  std::vector<std::string> columns = {"dataset",        "seed",      "method",
                                      "threshold_kind", "threshold", "matching",
                                      "outcome",        "class",     "center_distance_m"};
  for (const std::string side : {"estimate", "truth"}) {
    for (const char* field : {"id", "center_x_m", "center_y_m", "center_z_m", "half_diagonal_m",
                              "faces", "watertight"}) {
      columns.push_back(side + "_" + field);
    }
  }
  for (const char* field :
       {"truth_name", "truth_subtype", "truth_room", "truth_visible_fraction"}) {
    columns.push_back(field);
  }
  for (const PairScoreColumn& column : pairScoreColumns()) columns.emplace_back(column.name);
  return columns;
}

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
  return rows;
}

std::string objectsCsv(const Result& result) {
  std::string text = csvLine(objectColumns());
  for (const MethodEvaluation& method : result.evaluations) {
    for (const ObjectRow& row : method.objects) {
      const ScoredObject* estimate = row.estimate ? &method.estimates[*row.estimate] : nullptr;
      const ScoredObject* truth = row.truth ? &method.truths[*row.truth] : nullptr;
      std::vector<std::string> cells = {method.dataset,
                                        method.seed,
                                        method.method,
                                        name(row.threshold.kind),
                                        csvNumber(row.threshold.value),
                                        name(row.matching),
                                        name(row.outcome),
                                        (estimate ? estimate : truth)->class_name,
                                        csvNumber(row.center_distance_m)};
      appendObject(estimate, cells);
      appendObject(truth, cells);
      if (truth) {
        cells.insert(cells.end(), {truth->name, truth->subtype, truth->room,
                                   csvNumber(truth->visible_fraction)});
      } else {
        cells.insert(cells.end(), 4, "");
      }
      for (const PairScoreColumn& column : pairScoreColumns()) {
        cells.push_back(row.scores ? csvNumber((*row.scores).*column.value) : "");
      }
      text += csvLine(cells);
    }
  }
  return text;
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

std::vector<std::string> writeResult(AtomicFolder& folder, const Result& result) {
  const std::filesystem::path& out = folder.temporary();
  std::vector<std::string> remarks;
  if (!result.evaluations.empty()) {
    const std::vector<ScoreRow> scores = allScores(result);
    const ComparisonTable table = comparisonTable(scores, kAllMicro, result.notes);
    writeFileAtomic(out / "scores.csv", scoresCsv(scores));
    writeFileAtomic(out / "objects.csv", objectsCsv(result));
    writeFileAtomic(out / "variants.csv",
                    renderVariantsCsv(variantRows(result.evaluations, result.evaluation)));
    writeFileAtomic(out / "kappa.csv", kappaCsv(result));
    remarks = writeKappaReport(out, result.evaluations, result.evaluation);
    writeFileAtomic(out / "table.md", renderMarkdown(table));
    writeFileAtomic(out / "table.tex", renderLatex(table));
    writeFileAtomic(out / "table.csv", renderCsv(table));
    writeFileAtomic(out / "table.json", renderJson(table));
  }
  if (!result.timing.empty()) writeFileAtomic(out / "timing.csv", timingCsv(result.timing));
  if (!result.notes.empty()) {
    writeFileAtomic(out / kNotesFile, fmt::format("{}\n", fmt::join(result.notes, "\n")));
  }
  writeFileAtomic(out / "config.yaml", result.config);
  writeFileAtomic(out / "provenance.json", provenanceJson(result.provenance));
  folder.commit();
  return remarks;
}

}  // namespace hydrabench

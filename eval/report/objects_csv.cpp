// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/report/objects_csv.h"

#include <algorithm>
#include <charconv>
#include <map>
#include <numeric>
#include <optional>
#include <tuple>

#include <fmt/format.h>

#include "core/types/error.h"
#include "eval/evaluation/csv.h"

namespace hydrabench {
namespace {

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

/// Puts the rows of a file together again.
class Reader {
 public:
  explicit Reader(const CsvTable& table) : table_(table) {
    for (std::size_t i = 0; i < table.columns.size(); ++i) index_[table.columns[i]] = i;
  }

  std::vector<MethodEvaluation> read() {
    for (row_ = 0; row_ < table_.rows.size(); ++row_) {
      if (text("seed") == kPooledSeed) continue;
      MethodEvaluation& evaluation = of(text("dataset"), text("seed"), text("method"));
      const Label label = labelOf(text("class"));
      const bool missed = text("outcome") == name(ObjectRow::Outcome::kMissed);
      std::optional<std::size_t> estimate, truth;
      if (!missed) estimate = object("estimate_", label, evaluation.estimates);
      // The truth of an estimate that did not match is only the nearest; it has a row of its own.
      if (!text("truth_id").empty()) truth = object("truth_", label, evaluation.truths);
      if (text("outcome") != name(ObjectRow::Outcome::kMatched) ||
          text("matching") != kMatchingOneToOne) {
        continue;
      }
      PairScores scores;
      for (const PairScoreColumn& column : pairScoreColumns()) {
        scores.*column.value = number(std::string(column.name));
      }
      evaluation.pair_scores[{*estimate, *truth}] = scores;
    }
    for (MethodEvaluation& evaluation : evaluations_) orderTruths(evaluation);
    return std::move(evaluations_);
  }

 private:
  /// By id: two methods tell of the same truths in orders of their own.
  static void orderTruths(MethodEvaluation& evaluation) {
    std::vector<std::size_t> order(evaluation.truths.size());
    std::iota(order.begin(), order.end(), 0);
    std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
      return evaluation.truths[a].detection.id < evaluation.truths[b].detection.id;
    });
    std::vector<ScoredObject> truths;
    std::vector<std::size_t> place(order.size());
    for (std::size_t i = 0; i < order.size(); ++i) {
      truths.push_back(std::move(evaluation.truths[order[i]]));
      place[order[i]] = i;
    }
    evaluation.truths = std::move(truths);
    std::map<MatchedPair, PairScores> scores;
    for (const auto& [pair, value] : evaluation.pair_scores) {
      scores.emplace(MatchedPair{pair.estimate, place[pair.truth]}, value);
    }
    evaluation.pair_scores = std::move(scores);
  }

  const std::string& text(const std::string& column) const {
    return table_.rows[row_][index_.at(column)];
  }
  std::optional<double> number(const std::string& column) const {
    return table_.number(row_, index_.at(column));
  }

  MethodEvaluation& of(const std::string& dataset, const std::string& seed,
                       const std::string& method) {
    const auto [place, is_new] =
        known_.emplace(std::tuple(dataset, seed, method), evaluations_.size());
    if (is_new) {
      MethodEvaluation& evaluation = evaluations_.emplace_back();
      evaluation.dataset = dataset;
      evaluation.seed = seed;
      evaluation.method = method;
      objects_.emplace_back();
    }
    current_ = place->second;
    return evaluations_[current_];
  }

  Label labelOf(const std::string& class_name) {
    return labels_.emplace(class_name, static_cast<Label>(labels_.size())).first->second;
  }

  /// Index of the object in `objects`, where it is put if it is new.
  std::size_t object(const std::string& side, Label label, std::vector<ScoredObject>& objects) {
    const std::string& id = text(side + "id");
    const auto [place, is_new] = objects_[current_].emplace(side + id, objects.size());
    if (!is_new) return place->second;
    ScoredObject& object = objects.emplace_back();
    std::uint64_t value = 0;
    const auto [end, error] = std::from_chars(id.data(), id.data() + id.size(), value);
    if (error != std::errc() || end != id.data() + id.size()) {
      throw InputError(fmt::format("{}:{}: {}id: '{}', expected a whole number",
                                   table_.path.string(), row_ + 2, side, id));
    }
    object.detection.id = value;
    object.detection.label = label;
    object.detection.center = {number(side + "center_x_m").value_or(0),
                               number(side + "center_y_m").value_or(0),
                               number(side + "center_z_m").value_or(0)};
    object.detection.half_diagonal = number(side + "half_diagonal_m").value_or(0);
    object.class_name = text("class");
    object.faces = static_cast<std::size_t>(number(side + "faces").value_or(0));
    object.has_surface = object.faces > 0;
    object.watertight = text(side + "watertight") == "yes";
    if (side == "truth_") {
      object.name = text("truth_name");
      object.subtype = text("truth_subtype");
      object.room = text("truth_room");
      object.visible_fraction = number("truth_visible_fraction");
    }
    return place->second;
  }

  const CsvTable& table_;
  std::map<std::string, std::size_t> index_;
  std::size_t row_ = 0;
  std::vector<MethodEvaluation> evaluations_;
  std::map<std::tuple<std::string, std::string, std::string>, std::size_t> known_;
  std::vector<std::map<std::string, std::size_t>> objects_;  ///< index by side and id
  std::size_t current_ = 0;
  std::map<std::string, Label> labels_;
};

}  // namespace

std::string objectsCsv(const std::vector<MethodEvaluation>& evaluations) {
  std::string text = csvLine(objectColumns());
  for (const MethodEvaluation& method : evaluations) {
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

std::vector<MethodEvaluation> readObjectsCsv(const std::filesystem::path& path) {
  const CsvTable table = readCsv(path, objectColumns());
  return Reader(table).read();
}

}  // namespace hydrabench

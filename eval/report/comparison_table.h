// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "eval/evaluation/score_row.h"

namespace hydrabench {

/// A column of the comparison table. Declared once, in comparison_table.cpp; every format is made
/// from that list.
struct TableColumn {
  std::string metric;  ///< as in scores.csv
  std::string title;
  std::string latex_title;
  bool higher_is_better = true;
  int decimals = 3;
  bool ranked = true;  ///< the best three cells of a block are marked, as in the paper
};

struct TableCell {
  std::optional<double> value;  ///< nullopt prints as n/a
  std::optional<double> ci95_low;
  std::optional<double> ci95_high;
  int rank = 0;  ///< 1, 2, 3 for the best three different values of the column in its block; else 0
};

struct TableRow {
  std::string method;  ///< as in scores.csv
  std::string label;   ///< as printed
  std::vector<TableCell> cells;
};

/// Rows that compete: one dataset, one threshold, one matching semantics.
struct TableBlock {
  std::string dataset;
  std::string threshold_kind;
  double threshold = 0;
  std::string matching;
  std::vector<TableRow> rows;
};

struct ComparisonTable {
  std::string title;
  std::vector<TableColumn> columns;
  std::vector<TableBlock> blocks;  ///< all blocks of a dataset stand together
  std::vector<std::string> notes;
};

/// The comparison table of the paper (Table I) for one class (kAllMicro: all objects), every metric
/// threshold in the rows, both matching semantics, datasets and methods in order of appearance.
/// With several seeds of a dataset the pooled rows are the table. Throws InputError where two rows
/// claim one cell.
/// @param notes  what is to be said of the methods, printed below
ComparisonTable comparisonTable(const std::vector<ScoreRow>& rows,
                                const std::string& class_name = kAllMicro,
                                const std::vector<std::string>& notes = {});

/// The same table with every value less that of one method in its block: what a change to that
/// method gains or costs. Without counts, intervals and ranks. Throws InputError where no row is of
/// that method.
ComparisonTable differencesTo(const ComparisonTable& table, const std::string& method);

std::string methodLabel(const std::string& method);  ///< "hydra_plus_plus" -> "Hydra++"
bool isUpperBound(const std::string& method);  ///< knows the ground truth: competes with nobody

std::string renderTerminal(const ComparisonTable& table, bool color);
std::string renderMarkdown(const ComparisonTable& table);
std::string renderLatex(
    const ComparisonTable& table);  ///< booktabs; best three cells shaded with the paper's colours
std::string renderCsv(const ComparisonTable& table);
std::string renderJson(const ComparisonTable& table);

}  // namespace hydrabench

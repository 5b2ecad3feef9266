// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/report/comparison_table.h"

#include <algorithm>
#include <map>
#include <set>
#include <tuple>

#include <fmt/format.h>

#include "core/types/error.h"

namespace hydrabench {
namespace {

const std::vector<TableColumn> kColumns = {
    {"precision", "P↑", R"(P\,$\uparrow$)", true, 3, true},
    {"recall", "R↑", R"(R\,$\uparrow$)", true, 3, true},
    {"f1", "F1↑", R"(F$_1$\,$\uparrow$)", true, 3, true},
    {"chamfer_sq", "Chamf.↓", R"(Chamf.\,$\downarrow$)", false, 4, true},
    {"chamfer_sq_floor", "floor", "floor", false, 4, false},
    {"b_iou", "B-IoU↑", R"(B-IoU\,$\uparrow$)", true, 3, true},
    {"v_iou_solid", "V-IoU↑", R"(V-IoU\,$\uparrow$)", true, 3, true},
    {"chamfer_l1_all_gt", "Chamf.L1 all↓", R"(Chamf.$_{L1}^{\mathrm{all}}$\,$\downarrow$)", false,
     3, true},
    {"v_iou_solid_all_gt", "V-IoU all↑", R"(V-IoU$^{\mathrm{all}}$\,$\uparrow$)", true, 3, true},
    {"estimates", "est.", R"(est.)", true, 0, false},
    {"matched_estimates", "hit est.", R"(hit est.)", true, 0, false},
    {"found_truths", "found GT", R"(found GT)", true, 0, false},
    {"truths", "GT", R"(GT)", true, 0, false},
    {"duplicates", "dupl.", R"(dupl.)", false, 0, false},
    {"rank_stability", "> next", R"($>$ next)", true, 2, false},
};

/// Takes out a column in which nothing stands.
void dropEmptyColumn(const std::string& metric, ComparisonTable& table) {
  const auto column = std::find_if(table.columns.begin(), table.columns.end(),
                                   [&](const TableColumn& c) { return c.metric == metric; });
  const auto index = column - table.columns.begin();
  for (const TableBlock& block : table.blocks) {
    for (const TableRow& row : block.rows) {
      if (row.cells[static_cast<std::size_t>(index)].value) return;
    }
  }
  for (TableBlock& block : table.blocks) {
    for (TableRow& row : block.rows) row.cells.erase(row.cells.begin() + index);
  }
  table.columns.erase(column);
}

/// Marks the best three different printed values, so that two cells that look the same are marked
/// the same.
void rankColumn(TableBlock& block, std::size_t column, const TableColumn& spec) {
  if (!spec.ranked) return;
  const auto shown = [&](double value) { return fmt::format("{:.{}f}", value, spec.decimals); };
  std::set<std::pair<double, std::string>> distinct;
  for (const TableRow& row : block.rows) {
    const auto& value = row.cells[column].value;
    if (value && !isUpperBound(row.method)) {
      const std::string text = shown(*value);
      const double rounded = std::stod(text);
      distinct.emplace(spec.higher_is_better ? -rounded : rounded, text);
    }
  }
  int rank = 0;
  for (const auto& [key, text] : distinct) {
    if (++rank > 3) break;
    for (TableRow& row : block.rows) {
      TableCell& cell = row.cells[column];
      if (cell.value && !isUpperBound(row.method) && shown(*cell.value) == text) cell.rank = rank;
    }
  }
}

}  // namespace

bool isUpperBound(const std::string& method) {
  return method.starts_with("oracle_") || method == "ground_truth";
}

std::string methodLabel(const std::string& method) {
  static const std::map<std::string, std::string> kLabels = {
      {"hydra", "Hydra"},
      {"khronos", "Khronos"},
      {"template_cad", "Template CAD"},
      {"hydra_plus_plus", "Hydra++"},
      {"hydra_plus_plus_no_rmcc", "Hydra++ w/o RMCC"},
      {"hydra_plus_plus_extended", "Hydra++ extended"},
      {"hydra_plus_plus_refined", "Hydra++ refined"},
      {"hydra_plus_plus_latent_flow", "Hydra++, latent flow (built in)"},
      {"oracle_shape", "Oracle shape (bound)"},
      {"oracle_view", "Oracle view (bound)"},
      {"oracle_masks", "Oracle masks (bound)"},
      {"oracle_association", "Oracle assoc. (bound)"},
      {"oracle_all", "All oracles (bound)"},
      {"ground_truth", "Ground truth"},
  };
  const auto found = kLabels.find(method);
  return found == kLabels.end() ? method : found->second;
}

ComparisonTable differencesTo(const ComparisonTable& table, const std::string& method) {
  ComparisonTable result = table;
  std::erase_if(result.columns, [](const TableColumn& column) { return !column.ranked; });
  result.title += fmt::format(", less {}", methodLabel(method));
  bool found = false;
  for (TableBlock& block : result.blocks) {
    const auto reference = std::find_if(block.rows.begin(), block.rows.end(),
                                        [&](const TableRow& row) { return row.method == method; });
    if (reference == block.rows.end()) continue;
    found = true;
    const std::vector<TableCell> values = reference->cells;
    for (TableRow& row : block.rows) {
      std::vector<TableCell> cells;
      for (std::size_t c = 0; c < table.columns.size(); ++c) {
        if (!table.columns[c].ranked) continue;
        TableCell& cell = cells.emplace_back();
        const auto& value = row.cells[c].value;
        if (value && values[c].value) cell.value = *value - *values[c].value;
      }
      row.cells = std::move(cells);
    }
  }
  if (!found) throw InputError(fmt::format("no row of method '{}' to compare with", method));
  result.notes = {fmt::format("Every value less that of {}.", methodLabel(method))};
  return result;
}

ComparisonTable comparisonTable(const std::vector<ScoreRow>& rows, const std::string& class_name,
                                const std::vector<std::string>& notes) {
  using BlockKey = std::tuple<std::size_t, double, std::string>;
  using CellKey = std::tuple<std::size_t, double, std::string, std::string, std::string>;
  std::vector<std::string> methods;
  std::vector<std::string> datasets;
  std::set<BlockKey> block_keys;
  std::map<CellKey, const ScoreRow*> cells;
  const auto indexIn = [](std::vector<std::string>& names, const std::string& name) {
    const auto found = std::find(names.begin(), names.end(), name);
    const auto index = static_cast<std::size_t>(found - names.begin());
    if (found == names.end()) names.push_back(name);
    return index;
  };
  // With several seeds the pooled rows are the table; a single seed stands for itself.
  std::set<std::string> pooled;
  for (const ScoreRow& row : rows) {
    if (row.seed == kPooledSeed) pooled.insert(row.dataset);
  }
  for (const ScoreRow& row : rows) {
    if (row.class_name != class_name || row.threshold_kind != "tau_m" || !row.threshold) continue;
    if (pooled.contains(row.dataset) && row.seed != kPooledSeed) continue;
    indexIn(methods, row.method);
    const std::size_t dataset = indexIn(datasets, row.dataset);
    block_keys.emplace(dataset, *row.threshold, row.matching);
    const auto [cell, fresh] =
        cells.emplace(CellKey{dataset, *row.threshold, row.matching, row.method, row.metric}, &row);
    if (!fresh) {
      throw InputError(
          fmt::format("scores of dataset '{}', seed {} and of dataset '{}', seed {} compete for "
                      "one cell ({}, {}), expected rows of seed 'pooled'",
                      cell->second->dataset, cell->second->seed, row.dataset, row.seed, row.method,
                      row.metric));
    }
  }

  ComparisonTable table;
  table.columns = kColumns;
  for (const std::string& dataset : datasets) {
    table.title += (table.title.empty() ? "" : ", ") + dataset;
  }
  if (class_name != kAllMicro) table.title += ", " + class_name;
  for (const auto& [dataset, threshold, matching] : block_keys) {
    TableBlock block{datasets[dataset], "tau_m", threshold, matching, {}};
    for (const std::string& method : methods) {
      TableRow row{method, methodLabel(method), {}};
      for (const TableColumn& column : kColumns) {
        TableCell& cell = row.cells.emplace_back();
        const auto found = cells.find({dataset, threshold, matching, method, column.metric});
        if (found == cells.end()) continue;
        cell.value = found->second->value;
        cell.ci95_low = found->second->ci95_low;
        cell.ci95_high = found->second->ci95_high;
      }
      block.rows.push_back(std::move(row));
    }
    for (std::size_t c = 0; c < kColumns.size(); ++c) rankColumn(block, c, kColumns[c]);
    table.blocks.push_back(std::move(block));
  }
  dropEmptyColumn("rank_stability", table);
  table.notes = {
      "exists: an estimate counts if any ground-truth object of its class lies within tau_d, many "
      "may share one (the paper's rule); "
      "one_to_one: optimal assignment.",
      "Chamf. [m^2], B-IoU and V-IoU are means over matched pairs (the paper's rule); the columns "
      "marked 'all' are means over all "
      "ground-truth objects, a miss counting with the worst value.",
      "floor: what Chamf. would be for a perfect estimate, by sampling alone. dupl.: estimates "
      "inside the gate of an object that another one has taken.",
      "[low, high]: 95 % percentile bootstrap over objects.",
  };
  if (table.columns.back().metric == "rank_stability") {
    table.notes.push_back(
        "> next: how likely a method ranks above the next one in F1 when worlds and objects are "
        "drawn again.");
  }
  if (std::any_of(methods.begin(), methods.end(), isUpperBound)) {
    table.notes.push_back(
        "(bound): a stage of the method is told the ground truth. An upper bound, not a result; "
        "not ranked.");
  }
  table.notes.insert(table.notes.end(), notes.begin(), notes.end());
  return table;
}

}  // namespace hydrabench

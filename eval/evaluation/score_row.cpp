// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/evaluation/score_row.h"

#include <charconv>

#include <fmt/format.h>

#include "core/io/atomic_file.h"
#include "core/types/error.h"
#include "eval/evaluation/csv.h"

namespace hydrabench {
namespace {

const std::vector<std::string> kColumns = {
    "dataset", "seed",  "method", "class",    "threshold_kind", "threshold", "matching",
    "metric",  "value", "unit",   "ci95_low", "ci95_high",      "n"};

}  // namespace

const std::vector<std::string>& scoreColumns() { return kColumns; }

std::string scoresCsv(const std::vector<ScoreRow>& rows) {
  std::string text = csvLine(kColumns);
  for (const ScoreRow& row : rows) {
    text +=
        csvLine({row.dataset, row.seed, row.method, row.class_name, row.threshold_kind,
                 csvNumber(row.threshold), row.matching, row.metric, csvNumber(row.value), row.unit,
                 csvNumber(row.ci95_low), csvNumber(row.ci95_high), std::to_string(row.n)});
  }
  return text;
}

std::vector<ScoreRow> readScoresCsv(const std::filesystem::path& path) {
  const CsvTable table = readCsv(path, kColumns);
  std::vector<ScoreRow> rows;
  rows.reserve(table.rows.size());
  for (std::size_t i = 0; i < table.rows.size(); ++i) rows.push_back(scoreRowOf(table, i));
  return rows;
}

ScoreRow scoreRowOf(const CsvTable& table, std::size_t i, std::size_t first) {
  const auto text = [&](std::size_t column) { return table.rows[i][first + column]; };
  const auto number = [&](std::size_t column) { return table.number(i, first + column); };
  ScoreRow row;
  row.dataset = text(0);
  row.seed = text(1);
  row.method = text(2);
  row.class_name = text(3);
  row.threshold_kind = text(4);
  row.threshold = number(5);
  row.matching = text(6);
  row.metric = text(7);
  row.value = number(8);
  row.unit = text(9);
  row.ci95_low = number(10);
  row.ci95_high = number(11);
  const std::optional<double> n = number(12);
  if (!n || *n < 0) {
    throw InputError(
        fmt::format("{}:{}: n: '{}', expected a count", table.path.string(), i + 2, text(12)));
  }
  row.n = static_cast<std::size_t>(*n);
  return row;
}

}  // namespace hydrabench

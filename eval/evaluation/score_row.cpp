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
  for (std::size_t i = 0; i < table.rows.size(); ++i) {
    const std::vector<std::string>& cells = table.rows[i];
    ScoreRow& row = rows.emplace_back();
    row.dataset = cells[0];
    row.seed = cells[1];
    row.method = cells[2];
    row.class_name = cells[3];
    row.threshold_kind = cells[4];
    row.threshold = table.number(i, 5);
    row.matching = cells[6];
    row.metric = cells[7];
    row.value = table.number(i, 8);
    row.unit = cells[9];
    row.ci95_low = table.number(i, 10);
    row.ci95_high = table.number(i, 11);
    const std::optional<double> n = table.number(i, 12);
    if (!n || *n < 0) {
      throw InputError(
          fmt::format("{}:{}: n: '{}', expected a count", path.string(), i + 2, cells[12]));
    }
    row.n = static_cast<std::size_t>(*n);
  }
  return rows;
}

}  // namespace hydrabench

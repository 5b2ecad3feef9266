// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/report/html/csv_json.h"

#include <charconv>
#include <optional>
#include <set>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "core/types/error.h"
#include "eval/evaluation/csv.h"

namespace hydrabench {
namespace {

using Json = nlohmann::ordered_json;

const std::set<std::string> kNames = {"dataset",        "seed",  "method",   "method_a",
                                      "method_b",       "class", "matching", "metric",
                                      "threshold_kind", "stage", "unit"};

Json valueOf(const std::string& column, const std::string& cell) {
  if (kNames.contains(column)) return cell;
  if (cell.empty()) return nullptr;
  double value = 0;
  const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
  if (error != std::errc() || end != cell.data() + cell.size()) return cell;
  return std::stod(fmt::format("{:.6g}", value));
}

}  // namespace

std::string csvJson(const std::filesystem::path& path,
                    const std::function<bool(const CsvRecord&)>& keep) {
  if (!std::filesystem::exists(path)) return "null";
  const std::vector<std::vector<std::string>> records = readCsvCells(path);
  if (records.empty()) return "null";
  const std::vector<std::string>& columns = records.front();
  Json rows = Json::array();
  for (std::size_t line = 1; line < records.size(); ++line) {
    const std::vector<std::string>& cells = records[line];
    if (cells.size() != columns.size()) {
      throw InputError(fmt::format("{}:{}: {} cells, expected {} as in the header", path.string(),
                                   line + 1, cells.size(), columns.size()));
    }
    if (keep) {
      CsvRecord record;
      for (std::size_t c = 0; c < columns.size(); ++c) record[columns[c]] = cells[c];
      if (!keep(record)) continue;
    }
    Json row = Json::array();
    for (std::size_t c = 0; c < columns.size(); ++c) row.push_back(valueOf(columns[c], cells[c]));
    rows.push_back(std::move(row));
  }
  const Json json = {{"columns", columns}, {"rows", std::move(rows)}};
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace hydrabench

// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/evaluation/csv.h"

#include <charconv>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "core/io/atomic_file.h"
#include "core/types/error.h"

namespace hydrabench {
namespace {

/// Cells of the record that starts at `position`; moves past its end.
std::vector<std::string> nextRecord(const std::string& text, std::size_t& position) {
  std::vector<std::string> cells(1);
  bool quoted = false;
  for (; position < text.size(); ++position) {
    const char c = text[position];
    if (quoted) {
      if (c != '"') {
        cells.back() += c;
      } else if (position + 1 < text.size() && text[position + 1] == '"') {
        cells.back() += '"';
        ++position;
      } else {
        quoted = false;
      }
    } else if (c == '"') {
      quoted = true;
    } else if (c == ',') {
      cells.emplace_back();
    } else if (c == '\n') {
      ++position;
      return cells;
    } else if (c != '\r') {
      cells.back() += c;
    }
  }
  return cells;
}

}  // namespace

std::string csvLine(const std::vector<std::string>& cells) {
  std::string line;
  for (const std::string& cell : cells) {
    if (!line.empty() || &cell != &cells.front()) line += ',';
    if (cell.find_first_of(",\"\r\n") == std::string::npos) {
      line += cell;
      continue;
    }
    line += '"';
    for (const char c : cell) {
      if (c == '"') line += '"';
      line += c;
    }
    line += '"';
  }
  return line + '\n';
}

std::string csvNumber(std::optional<double> value) {
  return value ? fmt::format("{}", *value) : std::string();
}

std::optional<double> CsvTable::number(std::size_t row, std::size_t column) const {
  const std::string& cell = rows[row][column];
  if (cell.empty()) return std::nullopt;
  double value = 0;
  const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
  if (error != std::errc() || end != cell.data() + cell.size() || !std::isfinite(value)) {
    throw InputError(fmt::format("{}:{}: {}: '{}', expected a number or nothing", path.string(),
                                 row + 2, columns[column], cell));
  }
  return value;
}

std::vector<std::vector<std::string>> readCsvCells(const std::filesystem::path& path) {
  const std::string text = readFile(path);
  std::vector<std::vector<std::string>> records;
  for (std::size_t position = 0; position < text.size();) {
    records.push_back(nextRecord(text, position));
  }
  return records;
}

CsvTable readCsv(const std::filesystem::path& path, const std::vector<std::string>& columns) {
  const std::string text = readFile(path);
  CsvTable table{path, columns, {}};
  std::size_t position = 0;
  if (nextRecord(text, position) != columns) {
    throw InputError(
        fmt::format("{}:1: header is not '{}'", path.string(), fmt::join(columns, ",")));
  }
  while (position < text.size()) {
    table.rows.push_back(nextRecord(text, position));
    if (table.rows.back().size() != columns.size()) {
      throw InputError(fmt::format("{}:{}: {} columns, expected {}", path.string(),
                                   table.rows.size() + 1, table.rows.back().size(),
                                   columns.size()));
    }
  }
  return table;
}

}  // namespace hydrabench

// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace hydrabench {

/// One line of a CSV file (RFC 4180 quoting), newline included.
std::string csvLine(const std::vector<std::string>& cells);
/// Shortest text that reads back the same double; empty where undefined.
std::string csvNumber(std::optional<double> value);

struct CsvTable {
  std::filesystem::path path;
  std::vector<std::string> columns;
  std::vector<std::vector<std::string>> rows;

  /// The number in a cell; nullopt for an empty one. Throws InputError naming file, line and column
  /// for anything else.
  std::optional<double> number(std::size_t row, std::size_t column) const;
};

/// Cells of all records, the header's too, whatever their number.
std::vector<std::vector<std::string>> readCsvCells(const std::filesystem::path& path);

/// Reads a CSV file whose header must be `columns`. Throws InputError naming file and line.
CsvTable readCsv(const std::filesystem::path& path, const std::vector<std::string>& columns);

}  // namespace hydrabench

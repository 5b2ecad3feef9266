// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/audit/published_table.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <optional>

#include <fmt/format.h>

#include "core/io/atomic_file.h"
#include "core/types/error.h"
#include "eval/audit/latex_table.h"
#include "eval/evaluation/csv.h"

namespace hydrabench {
namespace {

using Cells = std::vector<std::string>;

/// Letters and digits in lower case: "F$_1$ [%]" is "f1".
std::string plain(const std::string& text) {
  std::string result;
  for (const char c : text) {
    if (std::isalnum(static_cast<unsigned char>(c)) != 0) {
      result += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    }
  }
  return result;
}

std::optional<std::size_t> columnNamed(const Cells& header, const std::vector<std::string>& names) {
  for (std::size_t i = 0; i < header.size(); ++i) {
    if (std::find(names.begin(), names.end(), plain(header[i])) != names.end()) return i;
  }
  return std::nullopt;
}

struct Columns {
  std::size_t precision, recall, f1;
  std::optional<std::size_t> method;
};
std::optional<Columns> scoreColumns(const Cells& header) {
  const auto precision = columnNamed(header, {"p", "prec", "precision"});
  const auto recall = columnNamed(header, {"r", "rec", "recall"});
  const auto f1 = columnNamed(header, {"f1", "f1score", "fscore", "fmeasure"});
  if (!precision || !recall || !f1) return std::nullopt;
  return Columns{*precision, *recall, *f1, columnNamed(header, {"method", "methods", "approach"})};
}

/// The first number in a cell with its decimals; a deviation or an interval may follow.
std::optional<PrintedScore> printedScore(const std::string& cell) {
  const std::size_t first = cell.find_first_of("0123456789");
  if (first == std::string::npos) return std::nullopt;
  const std::size_t begin = first > 0 && cell[first - 1] == '.' ? first - 1 : first;
  const std::size_t end = std::min(cell.find_first_not_of("0123456789.", begin), cell.size());
  const std::string number = cell.substr(begin, end - begin);
  const std::size_t point = number.find('.');
  const auto decimals =
      point == std::string::npos ? 0 : static_cast<double>(number.size() - point - 1);
  return PrintedScore{std::strtod(number.c_str(), nullptr), std::pow(10.0, -decimals)};
}

/// Rows of one table, below their header.
class TableReader {
 public:
  TableReader(std::string where, const Cells& header, const Columns& columns)
      : where_(std::move(where)), header_(header), columns_(columns) {}

  void add(const Cells& cells, std::vector<PublishedRow>& rows) {
    const std::size_t first_score = std::min({columns_.precision, columns_.recall, columns_.f1});
    std::size_t method = columns_.method.value_or(first_score);
    if (!columns_.method) {
      while (method > 0 && (method > cells.size() || trimmed(cells[method - 1]).empty())) --method;
      if (method == 0) return;  // a rule or an empty line
      --method;
    }
    for (std::size_t i = 0; i < std::min(method, cells.size()); ++i) {
      if (!trimmed(cells[i]).empty()) group_ = trimmed(cells[i]);
    }
    if (method >= cells.size() || trimmed(cells[method]).empty()) return;
    const auto score = [&](std::size_t column) -> std::optional<PrintedScore> {
      return column < cells.size() ? printedScore(cells[column]) : std::nullopt;
    };
    if (!score(columns_.precision) && !score(columns_.recall) && !score(columns_.f1)) return;
    PublishedRow row;
    row.group = group_;
    row.method = trimmed(cells[method]);
    for (const auto& [column, value] :
         {std::pair(columns_.precision, &row.precision), std::pair(columns_.recall, &row.recall),
          std::pair(columns_.f1, &row.f1)}) {
      const std::optional<PrintedScore> printed = score(column);
      if (!printed) {
        throw InputError(fmt::format("{}: row '{}', column '{}': '{}', expected a number", where_,
                                     row.method, trimmed(header_[column]),
                                     column < cells.size() ? trimmed(cells[column]) : ""));
      }
      *value = *printed;
    }
    rows.push_back(row);
  }

  static std::string trimmed(const std::string& text) {
    const std::size_t begin = text.find_first_not_of(" \t\r\n");
    if (begin == std::string::npos) return "";
    return text.substr(begin, text.find_last_not_of(" \t\r\n") - begin + 1);
  }

 private:
  std::string where_;
  Cells header_;
  Columns columns_;
  std::string group_;
};

std::vector<PublishedRow> rowsOf(const std::string& where, const std::vector<Cells>& table) {
  std::vector<PublishedRow> rows;
  std::optional<TableReader> reader;
  for (const Cells& cells : table) {
    if (reader) {
      reader->add(cells, rows);
    } else if (const auto columns = scoreColumns(cells)) {
      reader.emplace(where, cells, *columns);
    }
  }
  return rows;
}

/// Per cent to shares, the whole table at once: 0.9 beside 87.5 is per cent too.
void toShares(std::vector<PublishedRow>& rows) {
  const bool percent = std::any_of(rows.begin(), rows.end(), [](const PublishedRow& row) {
    return std::max({row.precision.value, row.recall.value, row.f1.value}) > 1.5;
  });
  if (!percent) return;
  for (PublishedRow& row : rows) {
    for (PrintedScore* score : {&row.precision, &row.recall, &row.f1}) {
      score->value /= 100;
      score->unit /= 100;
    }
  }
}

}  // namespace

std::vector<PublishedRow> readPublishedTable(const std::filesystem::path& path) {
  std::vector<PublishedRow> rows;
  if (path.extension() == ".tex") {
    for (const std::vector<Cells>& table : latexTables(readFile(path))) {
      std::vector<PublishedRow> of_table = rowsOf(path.string(), table);
      rows.insert(rows.end(), of_table.begin(), of_table.end());
    }
  } else {
    rows = rowsOf(path.string(), readCsvCells(path));
  }
  if (rows.empty()) {
    throw InputError(fmt::format("{}: no rows with scores, expected columns method, P, R and F1",
                                 path.string()));
  }
  toShares(rows);
  return rows;
}

}  // namespace hydrabench

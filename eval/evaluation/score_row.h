// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "eval/evaluation/csv.h"

namespace hydrabench {

inline constexpr const char* kAllMicro = "all_micro";  ///< pooled over objects of every class
inline constexpr const char* kAllMacro = "all_macro";  ///< mean over classes
inline constexpr const char* kMatchingExists = "exists";
inline constexpr const char* kMatchingOneToOne = "one_to_one";
inline constexpr const char* kPooledSeed = "pooled";

/// One number of an evaluation; a line of scores.csv. docs/metrics.md defines every metric.
struct ScoreRow {
  std::string dataset;
  std::string seed;  ///< a number, or "pooled"
  std::string method;
  std::string class_name;      ///< a class, kAllMicro or kAllMacro
  std::string threshold_kind;  ///< "tau_m" or "kappa"; empty where no threshold is involved
  std::optional<double> threshold;
  std::string matching;  ///< kMatchingExists or kMatchingOneToOne
  std::string metric;
  std::optional<double> value;  ///< nullopt: undefined, written as an empty field
  std::string unit;             ///< "m", "m^2", "count"; empty for ratios
  std::optional<double> ci95_low;
  std::optional<double> ci95_high;
  std::size_t n =
      0;  ///< what the value was computed over: objects, pairs, or classes for macro means
};

/// scores.csv, the contract of docs/metrics.md: numbers are written with as many digits as read
/// back the same double.
std::string scoresCsv(const std::vector<ScoreRow>& rows);
/// Throws InputError naming file, line and column.
std::vector<ScoreRow> readScoresCsv(const std::filesystem::path& path);

/// The columns of scores.csv, and a row of a table that has them from column `first` on.
const std::vector<std::string>& scoreColumns();
ScoreRow scoreRowOf(const CsvTable& table, std::size_t row, std::size_t first = 0);

}  // namespace hydrabench

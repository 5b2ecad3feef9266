// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "metrics/count_recovery.h"

namespace hydrabench {

/// A row of a detection table in print.
struct PublishedRow {
  std::string group;  ///< what the rows of a block share, e.g. "tau_d = 0.2 m"; may be empty
  std::string method;
  PrintedScore precision;
  PrintedScore recall;
  PrintedScore f1;
};

/// Reads a table from CSV (a header with method, P or precision, R or recall, F1, and any others)
/// or LaTeX (.tex: every tabular that has these three columns). A column left of the method, as
/// with \multirow, names the group. Scores are shares of one, or per cent where one is above 1.
/// Throws InputError naming file, row and column.
std::vector<PublishedRow> readPublishedTable(const std::filesystem::path& path);

}  // namespace hydrabench

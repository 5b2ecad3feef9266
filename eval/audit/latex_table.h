// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

namespace hydrabench {

/// Cells of every tabular in a LaTeX source, row by row, as plain text: comments, rules, boxes
/// (\multirow, \multicolumn, \parbox, \rotatebox) and braces are taken away, of other commands the
/// name stays ("Ours w/o \RMCC" is "Ours w/o RMCC"). Text without a tabular is one table. Reads
/// what papers contain, not the whole of LaTeX.
std::vector<std::vector<std::vector<std::string>>> latexTables(const std::string& source);

}  // namespace hydrabench

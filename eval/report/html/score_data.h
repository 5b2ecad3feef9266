// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "eval/evaluation/score_row.h"
#include "eval/report/comparison_table.h"
#include "eval/report/plot.h"

namespace hydrabench {

/// Comparison tables of all classes, all_micro first, each with the columns it has, the marks of
/// the best three and the same table as CSV and TeX.
std::string tablesJson(const std::vector<ScoreRow>& rows, const std::vector<std::string>& notes);
std::string tableJson(const ComparisonTable& table, const std::string& class_name);

/// [{"name", "label", "bound"}] in the order in which they are first named: a method has the same
/// colour wherever it is shown.
std::string methodsJson(const std::vector<std::string>& methods);

/// Curves over kappa: exact steps and intervals, of the rows that stand for a dataset (the pooled
/// ones where there are several worlds), all classes pooled.
std::string kappaJson(const std::filesystem::path& result);

std::string plotJson(const Plot& plot);

}  // namespace hydrabench

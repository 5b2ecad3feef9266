// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <string>

namespace hydrabench {

/// One record of a CSV file by column.
using CsvRecord = std::map<std::string, std::string>;

/// {"columns": [...], "rows": [[...], ...]} of a CSV file with a header: numbers to six digits,
/// null for an empty cell, names (dataset, seed, method, class ...) as text whatever they look
/// like. "null" where the file does not exist. Throws InputError naming file and line where a
/// record has another number of cells than the header.
/// @param keep  which records; all without it
std::string csvJson(const std::filesystem::path& path,
                    const std::function<bool(const CsvRecord&)>& keep = {});

}  // namespace hydrabench

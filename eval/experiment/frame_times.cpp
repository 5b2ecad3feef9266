// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/experiment/frame_times.h"

#include <optional>

#include <fmt/format.h>

#include "eval/evaluation/csv.h"

namespace hydrabench {
namespace {

const std::vector<std::string> kColumns = {"dataset", "seed",    "method",
                                           "frame",   "wall_ms", "yardstick_ms"};

}  // namespace

std::string frameTimesCsv(const std::vector<FrameTimes>& times) {
  std::string text = csvLine(kColumns);
  for (const FrameTimes& of_method : times) {
    for (std::size_t i = 0; i < of_method.wall_ms.size(); ++i) {
      text += csvLine(
          {of_method.dataset, of_method.seed, of_method.method, std::to_string(i),
           fmt::format("{:.4f}", of_method.wall_ms[i]),
           of_method.yardstick_ms.empty() ? "" : fmt::format("{:.4f}", of_method.yardstick_ms[i])});
    }
  }
  return text;
}

std::vector<FrameTimes> readFrameTimesCsv(const std::filesystem::path& path) {
  const std::vector<std::vector<std::string>> cells = readCsvCells(path);
  const bool has_yardstick = cells.empty() || cells.front().size() == kColumns.size();
  const CsvTable table =
      readCsv(path, has_yardstick ? kColumns
                                  : std::vector<std::string>(kColumns.begin(), kColumns.end() - 1));
  std::vector<FrameTimes> times;
  for (std::size_t i = 0; i < table.rows.size(); ++i) {
    const std::vector<std::string>& row = table.rows[i];
    const bool goes_on = !times.empty() && times.back().dataset == row[0] &&
                         times.back().seed == row[1] && times.back().method == row[2];
    if (!goes_on) times.push_back({row[0], row[1], row[2], {}, {}});
    times.back().wall_ms.push_back(table.number(i, 4).value_or(0));
    const auto yardstick_ms = has_yardstick ? table.number(i, 5) : std::nullopt;
    if (yardstick_ms) times.back().yardstick_ms.push_back(*yardstick_ms);
  }
  return times;
}

}  // namespace hydrabench

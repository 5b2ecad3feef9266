// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/experiment/frame_times.h"

#include <algorithm>
#include <optional>

#include <fmt/format.h>

#include "eval/evaluation/csv.h"

namespace hydrabench {
namespace {

const std::vector<std::string> kColumns = {"dataset", "seed",         "method",        "frame",
                                           "wall_ms", "yardstick_ms", "instructions_m"};
constexpr std::size_t kOldestColumns = 5;  ///< of results of older programs, up to wall_ms

std::string cell(const std::vector<double>& values, std::size_t i) {
  return i < values.size() ? fmt::format("{:.4f}", values[i]) : "";
}

}  // namespace

std::string frameTimesCsv(const std::vector<FrameTimes>& times) {
  std::string text = csvLine(kColumns);
  for (const FrameTimes& of_method : times) {
    for (std::size_t i = 0; i < of_method.numFrames(); ++i) {
      text += csvLine({of_method.dataset, of_method.seed, of_method.method, std::to_string(i),
                       cell(of_method.wall_ms, i), cell(of_method.yardstick_ms, i),
                       cell(of_method.instructions, i)});
    }
  }
  return text;
}

std::vector<FrameTimes> readFrameTimesCsv(const std::filesystem::path& path) {
  const std::vector<std::vector<std::string>> cells = readCsvCells(path);
  const std::size_t there = cells.empty() ? kColumns.size() : cells.front().size();
  const std::size_t columns = std::clamp(there, kOldestColumns, kColumns.size());
  const CsvTable table =
      readCsv(path, {kColumns.begin(), kColumns.begin() + static_cast<std::ptrdiff_t>(columns)});
  std::vector<FrameTimes> times;
  for (std::size_t i = 0; i < table.rows.size(); ++i) {
    const std::vector<std::string>& row = table.rows[i];
    const bool goes_on = !times.empty() && times.back().dataset == row[0] &&
                         times.back().seed == row[1] && times.back().method == row[2];
    if (!goes_on) times.push_back({row[0], row[1], row[2], {}, {}, {}});
    const auto take = [&](std::size_t column, std::vector<double>& values) {
      if (column >= columns) return;
      if (const auto value = table.number(i, column)) values.push_back(*value);
    };
    take(4, times.back().wall_ms);
    take(5, times.back().yardstick_ms);
    take(6, times.back().instructions);
  }
  return times;
}

}  // namespace hydrabench

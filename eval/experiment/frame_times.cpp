// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/experiment/frame_times.h"

#include <fmt/format.h>

#include "eval/evaluation/csv.h"

namespace hydrabench {
namespace {

const std::vector<std::string> kColumns = {"dataset", "seed", "method", "frame", "wall_ms"};

}  // namespace

std::string frameTimesCsv(const std::vector<FrameTimes>& times) {
  std::string text = csvLine(kColumns);
  for (const FrameTimes& of_method : times) {
    for (std::size_t i = 0; i < of_method.wall_ms.size(); ++i) {
      text += csvLine({of_method.dataset, of_method.seed, of_method.method, std::to_string(i),
                       fmt::format("{:.4f}", of_method.wall_ms[i])});
    }
  }
  return text;
}

std::vector<FrameTimes> readFrameTimesCsv(const std::filesystem::path& path) {
  const CsvTable table = readCsv(path, kColumns);
  std::vector<FrameTimes> times;
  for (std::size_t i = 0; i < table.rows.size(); ++i) {
    const std::vector<std::string>& row = table.rows[i];
    const bool goes_on = !times.empty() && times.back().dataset == row[0] &&
                         times.back().seed == row[1] && times.back().method == row[2];
    if (!goes_on) times.push_back({row[0], row[1], row[2], {}});
    times.back().wall_ms.push_back(table.number(i, 4).value_or(0));
  }
  return times;
}

}  // namespace hydrabench

// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace hydrabench {

/// What each frame of a world cost a method, warm-up left out: wall clock, or instructions where
/// those were counted (then there are no times: a program that is counted is slow).
struct FrameTimes {
  std::string dataset;
  std::string seed;
  std::string method;
  std::vector<double> wall_ms;  ///< in the order of the frames
  /// What the Yardstick took beside each frame; empty in results of older programs.
  std::vector<double> yardstick_ms;
  std::vector<double> instructions;  ///< [10^6], InstructionCounter

  bool isCounted() const { return !instructions.empty(); }
  std::size_t numFrames() const { return std::max(wall_ms.size(), instructions.size()); }
};

inline constexpr const char* kFrameTimesFile = "frame_times.csv";

/// A row per frame: dataset, seed, method, frame (counted from the first that counts), wall_ms,
/// yardstick_ms, instructions_m.
std::string frameTimesCsv(const std::vector<FrameTimes>& times);
/// Throws InputError naming file, line and column.
std::vector<FrameTimes> readFrameTimesCsv(const std::filesystem::path& path);

}  // namespace hydrabench

// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace hydrabench {

/// How long a method took for each frame of a world, warm-up left out; wall clock.
struct FrameTimes {
  std::string dataset;
  std::string seed;
  std::string method;
  std::vector<double> wall_ms;  ///< in the order of the frames
  /// What the Yardstick took beside each frame; empty in results of older programs.
  std::vector<double> yardstick_ms;
};

inline constexpr const char* kFrameTimesFile = "frame_times.csv";

/// A row per frame: dataset, seed, method, frame (counted from the first that is timed), wall_ms,
/// yardstick_ms.
std::string frameTimesCsv(const std::vector<FrameTimes>& times);
/// Throws InputError naming file, line and column.
std::vector<FrameTimes> readFrameTimesCsv(const std::filesystem::path& path);

}  // namespace hydrabench

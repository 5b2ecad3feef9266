// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

namespace hydrabench {

/// What is written down beside the prediction of a run.
struct RunRecord {
  std::size_t frames = 0;
  double frame_period_s = 0;  ///< mean time between frames; 0 for fewer than two
};
inline constexpr const char* kRunRecordFile = "run.json";

/// With the provenance of this program and machine.
std::string runRecordJson(const RunRecord& record);
/// Throws InputError naming the file.
RunRecord readRunRecord(const std::filesystem::path& path);

}  // namespace hydrabench

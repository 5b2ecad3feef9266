// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

namespace hydrabench {

/// Of a sweep's folder: its table, its plots over the first axis, the pictures in plots/ and the
/// tables of a tau_O sweep. "null" for any other result.
std::string sweepJson(const std::filesystem::path& result);

}  // namespace hydrabench

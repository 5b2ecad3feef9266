// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

namespace hydrabench {

/// What every training begins with: its folder, whether new or from a call before, with the
/// resolved config in config.yaml (InputError where another one stands there); libtorch's work on
/// the threads that ask for it; and its seed.
void beginTraining(const std::filesystem::path& out, const std::string& resolved,
                   std::uint64_t seed);

}  // namespace hydrabench

// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

namespace hydrabench {

/// Writes the config of a training beside its checkpoints, or throws InputError where another one
/// stands there.
void requireSameConfig(const std::filesystem::path& file, const std::string& resolved);

}  // namespace hydrabench

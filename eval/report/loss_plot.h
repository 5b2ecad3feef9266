// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

namespace hydrabench {

/// Draws a training's loss.csv (eval/training/loss_file.h) as loss.png and loss.svg beside it.
/// Returns an empty text, or one line that says why there is no picture.
std::string drawLosses(const std::filesystem::path& loss_csv);

}  // namespace hydrabench

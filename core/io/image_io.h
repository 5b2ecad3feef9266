// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>

#include "core/types/color.h"
#include "core/types/image.h"

namespace hydrabench {

/// Readers take PNG (any bit depth, grey or colour) and JPEG, by content. They throw InputError
/// naming the file for a missing, truncated or foreign file and for a channel count or bit depth
/// that cannot be what was asked for.
Image<Rgb> readColorImage(const std::filesystem::path& path);
/// Single-channel integers: 8- or 16-bit grey PNG. Labels, instances, raw depth.
Image<std::uint16_t> readGrayImage(const std::filesystem::path& path);

/// Writers are atomic and throw OutputError. PNG bytes depend on the pixels only.
void writeColorPng(const std::filesystem::path& path, const Image<Rgb>& image);
void writeGrayPng(const std::filesystem::path& path,
                  const Image<std::uint16_t>& image);                                    ///< 16 bit
void writeGrayPng(const std::filesystem::path& path, const Image<std::uint8_t>& image);  ///< 8 bit

}  // namespace hydrabench

// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "core/types/color.h"
#include "core/types/image.h"

namespace hydrabench {

/// libpng behind plain functions; bytes in, pixels out. `name` is what error messages call the
/// source. Used by image_io.cpp only.
bool isPng(std::string_view bytes);
Image<Rgb> decodeColorPng(std::string_view bytes, const std::string& name);
Image<std::uint16_t> decodeGrayPng(std::string_view bytes, const std::string& name);

/// The settings are fixed, so the bytes depend on the pixels alone (and on the version of zlib).
std::string encodePng(const Image<Rgb>& image);
std::string encodePng(const Image<std::uint8_t>& image);
std::string encodePng(const Image<std::uint16_t>& image);

}  // namespace hydrabench

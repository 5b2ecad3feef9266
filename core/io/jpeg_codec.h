// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

#include "core/types/color.h"
#include "core/types/image.h"

namespace hydrabench {

/// libjpeg behind plain functions; bytes in, pixels out. `name` is what error messages call the
/// source. Files are read by image_io.cpp.
bool isJpeg(std::string_view bytes);
Image<Rgb> decodeJpeg(std::string_view bytes, const std::string& name);

/// For pictures that are looked at, not measured in. The bytes depend on the pixels alone (and on
/// the version of libjpeg). The image must have pixels.
/// @param quality  1 to 100; 80 is hard to tell from the original
std::string encodeJpeg(const Image<Rgb>& image, int quality);

}  // namespace hydrabench

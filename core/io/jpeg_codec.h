// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

#include "core/types/color.h"
#include "core/types/image.h"

namespace hydrabench {

/// libjpeg behind a plain function. `name` is what error messages call the source. Used by
/// image_io.cpp only.
bool isJpeg(std::string_view bytes);
Image<Rgb> decodeJpeg(std::string_view bytes, const std::string& name);

}  // namespace hydrabench

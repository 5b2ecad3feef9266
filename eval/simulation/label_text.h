// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

#include "core/types/color.h"
#include "core/types/image.h"

namespace hydrabench {

/// Text in pictures, in a built-in 5 x 7 pixel font (ASCII; anything else is drawn as a box).
inline constexpr int kTextHeight = 7;  ///< [px] at scale 1, without descenders' extra row

int textWidth(std::string_view text, int scale = 1);  ///< [px]
/// (u, v) is the upper left corner. What lies outside the image is cut off.
void drawText(Image<Rgb>& image, int u, int v, std::string_view text, Rgb color, int scale = 1);

}  // namespace hydrabench

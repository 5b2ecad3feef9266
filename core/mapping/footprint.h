// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

namespace hydrabench {

/// Pixels from (u0, v0) to (u1, v1), both inclusive.
struct PixelRect {
  int u0 = 0;
  int v0 = 0;
  int u1 = 0;
  int v1 = 0;
};

/// Where a convex body appears in the image.
struct Footprint {
  bool outside = false;  ///< no point of it is seen
  bool inside = false;   ///< every point of it is seen
  PixelRect pixels;      ///< all that interpolation at any of its points may read
};

}  // namespace hydrabench

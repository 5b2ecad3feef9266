// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstdint>
#include <vector>

#include "core/types/random.h"

namespace hydrabench {

/// Mean 0, deviation 1 from 64 random bits: the sum of four 16-bit numbers (Irwin-Hall). Close to a
/// normal within 3.4 deviations, where it ends; a few nanoseconds, and the same on every platform.
inline float cheapNormal(std::uint64_t bits) {
  const auto sum = static_cast<std::int32_t>((bits & 0xffff) + (bits >> 16 & 0xffff) +
                                             (bits >> 32 & 0xffff) + (bits >> 48)) -
                   2 * 65535;
  return static_cast<float>(sum) * (1.7320508f / 65536.0f);
}

/// Random bits of pixel `index` in one stream; a pure function.
inline std::uint64_t pixelBits(std::uint64_t seed, std::size_t index) {
  return mixBits(seed + 0x9e3779b97f4a7c15ull * index);
}

/// [0, 1) from 16 bits.
inline float unitFrom16(std::uint64_t bits) {
  return static_cast<float>(bits & 0xffff) * 0x1.0p-16f;
}

/// Nearest integer of |x| < 1000; std::lround is a call into the library, and there are several per
/// pixel.
inline int nearestInt(float x) { return static_cast<int>(x + 1024.5f) - 1024; }

/// Smooth noise over an image, mean 0, deviation 1 everywhere: normals on a lattice, blended
/// linearly and rescaled to unit variance.
class NoiseField {
 public:
  NoiseField(int width, int height, double spacing_px, std::uint64_t seed)
      : columns_(static_cast<int>(width / spacing_px) + 2),
        scale_(static_cast<float>(1 / spacing_px)) {
    const int rows = static_cast<int>(height / spacing_px) + 2;
    values_.resize(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows));
    for (std::size_t i = 0; i < values_.size(); ++i) values_[i] = cheapNormal(pixelBits(seed, i));
  }

  float at(int u, int v) const {
    const float x = scale_ * static_cast<float>(u);
    const float y = scale_ * static_cast<float>(v);
    const int column = static_cast<int>(x);
    const int row = static_cast<int>(y);
    const float fx = x - static_cast<float>(column);
    const float fy = y - static_cast<float>(row);
    const float* low = values_.data() +
                       static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
                       static_cast<std::size_t>(column);
    const float* high = low + columns_;
    const float sum =
        (1 - fy) * ((1 - fx) * low[0] + fx * low[1]) + fy * ((1 - fx) * high[0] + fx * high[1]);
    const float variance = ((1 - fx) * (1 - fx) + fx * fx) * ((1 - fy) * (1 - fy) + fy * fy);
    return sum / std::sqrt(variance);
  }

 private:
  int columns_;
  float scale_;
  std::vector<float> values_;
};

}  // namespace hydrabench

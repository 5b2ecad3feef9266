// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>

#include "core/types/image.h"

namespace hydrabench {

/// Depth in metres from multiples of a quantum. The product is taken in float: a sensor that rounds
/// to `quantum * n` in float is reproduced to the bit.
Image<float> depthFromQuanta(const Image<std::uint16_t>& quanta, double quantum_m);
/// The reverse; nullopt where some pixel is not exactly such a multiple, or too large for 16 bit.
std::optional<Image<std::uint16_t>> quantaFromDepth(const Image<float>& depth, double quantum_m);

/// Portable float map (one channel, little-endian, rows from the bottom up), which OpenCV and
/// ImageMagick read as well: the lossless form of depth that is no multiple of a quantum. Reading
/// refuses what cannot be depth (NaN, infinite, negative), naming the pixel.
Image<float> readDepthPfm(const std::filesystem::path& path);
void writeDepthPfm(const std::filesystem::path& path, const Image<float>& depth);

/// True where at least one pixel was measured.
bool hasDepth(const Image<float>& depth);

}  // namespace hydrabench

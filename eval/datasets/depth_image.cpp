// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/datasets/depth_image.h"

#include <algorithm>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstring>
#include <string>
#include <string_view>

#include <fmt/format.h>

#include "core/io/atomic_file.h"
#include "core/types/error.h"

namespace hydrabench {
namespace {

static_assert(std::endian::native == std::endian::little);

/// The next word of the header; what remains starts after exactly one white space.
std::string_view nextWord(std::string_view& text) {
  const std::size_t end = std::min(text.find_first_of(" \n"), text.size());
  const std::string_view word = text.substr(0, end);
  text.remove_prefix(std::min(end + 1, text.size()));
  return word;
}

template <typename Number>
bool parseWhole(std::string_view word, Number& number) {
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
  return error == std::errc() && end == word.data() + word.size();
}

}  // namespace

Image<float> depthFromQuanta(const Image<std::uint16_t>& quanta, double quantum_m) {
  const auto quantum = static_cast<float>(quantum_m);
  Image<float> depth(quanta.width(), quanta.height());
  std::transform(quanta.begin(), quanta.end(), depth.begin(),
                 [quantum](std::uint16_t n) { return quantum * static_cast<float>(n); });
  return depth;
}

std::optional<Image<std::uint16_t>> quantaFromDepth(const Image<float>& depth, double quantum_m) {
  const auto quantum = static_cast<float>(quantum_m);
  Image<std::uint16_t> quanta(depth.width(), depth.height());
  for (std::size_t i = 0; i < depth.size(); ++i) {
    const float z = depth.data()[i];
    const float n = std::nearbyint(z / quantum);
    if (!(n >= 0 && n <= 65535) || quantum * n != z) return std::nullopt;
    quanta.data()[i] = static_cast<std::uint16_t>(n);
  }
  return quanta;
}

Image<float> readDepthPfm(const std::filesystem::path& path) {
  const std::string bytes = readFile(path);
  std::string_view rest = bytes;
  int width = 0;
  int height = 0;
  double scale = 0;
  if (nextWord(rest) != "Pf" || !parseWhole(nextWord(rest), width) ||
      !parseWhole(nextWord(rest), height) || !parseWhole(nextWord(rest), scale) || width <= 0 ||
      height <= 0 || width > 65535 || height > 65535 || !(scale < 0)) {
    throw InputError(
        fmt::format("{}: not a one-channel little-endian portable float map (PFM)", path.string()));
  }
  const auto row_bytes = static_cast<std::size_t>(width) * sizeof(float);
  if (rest.size() != row_bytes * static_cast<std::size_t>(height)) {
    throw InputError(fmt::format("{}: {} x {} pixels need {} bytes after the header, found {}",
                                 path.string(), width, height,
                                 row_bytes * static_cast<std::size_t>(height), rest.size()));
  }
  Image<float> depth(width, height);
  for (int v = 0; v < height; ++v) {
    std::memcpy(&depth(0, v), rest.data() + static_cast<std::size_t>(height - 1 - v) * row_bytes,
                row_bytes);
    for (int u = 0; u < width; ++u) {
      const float z = depth(u, v);
      if (!(z >= 0) || std::isinf(z)) {
        throw InputError(fmt::format("{}: depth {} at pixel ({}, {}), expected metres from 0 on",
                                     path.string(), z, u, v));
      }
    }
  }
  return depth;
}

void writeDepthPfm(const std::filesystem::path& path, const Image<float>& depth) {
  std::string bytes = fmt::format("Pf\n{} {}\n-1.0\n", depth.width(), depth.height());
  const auto row_bytes = static_cast<std::size_t>(depth.width()) * sizeof(float);
  for (int v = depth.height() - 1; v >= 0; --v) {
    bytes.append(reinterpret_cast<const char*>(&depth(0, v)), row_bytes);
  }
  writeFileAtomic(path, bytes);
}

bool hasDepth(const Image<float>& depth) {
  return std::any_of(depth.begin(), depth.end(), [](float z) { return z > 0; });
}

}  // namespace hydrabench

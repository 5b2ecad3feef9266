// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <utility>
#include <vector>

namespace hydrabench {

/// H x W pixels in row order. (u, v) = (column, row); integer coordinates are pixel centres.
template <typename Pixel>
class Image {
 public:
  Image() = default;
  Image(int width, int height, Pixel fill = {})
      : width_(width),
        height_(height),
        pixels_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), fill) {}

  int width() const { return width_; }
  int height() const { return height_; }
  std::size_t size() const { return pixels_.size(); }
  bool empty() const { return pixels_.empty(); }
  bool contains(int u, int v) const { return u >= 0 && v >= 0 && u < width_ && v < height_; }

  Pixel& operator()(int u, int v) { return pixels_[index(u, v)]; }
  const Pixel& operator()(int u, int v) const { return pixels_[index(u, v)]; }

  Pixel* data() { return pixels_.data(); }
  const Pixel* data() const { return pixels_.data(); }
  auto begin() { return pixels_.begin(); }
  auto end() { return pixels_.end(); }
  auto begin() const { return pixels_.begin(); }
  auto end() const { return pixels_.end(); }
  void fill(const Pixel& value) { std::fill(pixels_.begin(), pixels_.end(), value); }

  friend bool operator==(const Image&, const Image&) = default;

 private:
  std::size_t index(int u, int v) const {
    assert(contains(u, v));
    return static_cast<std::size_t>(v) * static_cast<std::size_t>(width_) +
           static_cast<std::size_t>(u);
  }

  int width_ = 0;
  int height_ = 0;
  std::vector<Pixel> pixels_;
};

}  // namespace hydrabench

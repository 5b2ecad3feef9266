// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "core/io/jpeg_codec.h"

#include <cmath>
#include <cstdlib>

#include <gtest/gtest.h>

namespace hydrabench {
namespace {

Image<Rgb> waves() {
  Image<Rgb> image(67, 41);
  for (int v = 0; v < image.height(); ++v) {
    for (int u = 0; u < image.width(); ++u) {
      const auto wave = [&](double x) {
        return static_cast<std::uint8_t>(std::lround(127 + 100 * std::sin(x)));
      };
      image(u, v) = {wave(u / 9.0), wave(v / 7.0), wave((u + v) / 11.0)};
    }
  }
  return image;
}

int largestChange(const Image<Rgb>& a, const Image<Rgb>& b) {
  int largest = 0;
  for (int v = 0; v < a.height(); ++v) {
    for (int u = 0; u < a.width(); ++u) {
      for (const auto channel : {&Rgb::r, &Rgb::g, &Rgb::b}) {
        largest = std::max(largest, std::abs(a(u, v).*channel - b(u, v).*channel));
      }
    }
  }
  return largest;
}

TEST(JpegCodec, APictureComesBackAlmostAsItWas) {
  const Image<Rgb> back = decodeJpeg(encodeJpeg(waves(), 95), "waves");
  ASSERT_EQ(back.width(), 67);
  ASSERT_EQ(back.height(), 41);
  EXPECT_LE(largestChange(waves(), back), 25);
  EXPECT_GT(largestChange(waves(), Image<Rgb>(67, 41)), 200);
}

TEST(JpegCodec, LowerQualityTakesFewerBytes) {
  EXPECT_LT(encodeJpeg(waves(), 40).size(), encodeJpeg(waves(), 95).size());
  EXPECT_TRUE(isJpeg(encodeJpeg(waves(), 40)));
}

TEST(JpegCodec, SamePixelsGiveSameBytes) {
  EXPECT_EQ(encodeJpeg(waves(), 80), encodeJpeg(waves(), 80));
}

}  // namespace
}  // namespace hydrabench

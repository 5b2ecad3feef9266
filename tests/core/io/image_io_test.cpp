// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "core/io/image_io.h"

#include <string>
#include <vector>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/io/atomic_file.h"
#include "core/parallel/parallel_for.h"
#include "core/types/error.h"
#include "core/types/random.h"
#include "tests/support/temporary_folder.h"

namespace hydrabench {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

const std::filesystem::path kData = std::filesystem::path(HYDRABENCH_TEST_DATA_DIR) / "images";

/// Looks a little like a rendered frame: smooth ramps, edges, noise in the lowest bits.
Image<Rgb> picture(int width, int height) {
  Image<Rgb> image(width, height);
  Random random(7);
  for (int v = 0; v < height; ++v) {
    for (int u = 0; u < width; ++u) {
      const auto dither = static_cast<int>(random.index(3));
      const int patch = ((u / 90) * 37 + (v / 60) * 91) % 120;
      image(u, v) = {static_cast<std::uint8_t>(patch + u * 60 / width + dither),
                     static_cast<std::uint8_t>(patch + v * 60 / height + dither),
                     static_cast<std::uint8_t>(patch + 40 + dither)};
    }
  }
  return image;
}

TEST(ImageIo, ColorSurvivesPng) {
  TemporaryFolder folder;
  const Image<Rgb> image = picture(33, 17);
  writeColorPng(folder / "a.png", image);
  EXPECT_EQ(readColorImage(folder / "a.png"), image);
}

TEST(ImageIo, SixteenBitGreySurvivesWithItsByteOrder) {
  TemporaryFolder folder;
  Image<std::uint16_t> image(5, 3);
  image(0, 0) = 1;
  image(1, 0) = 256;
  image(2, 1) = 65535;
  image(4, 2) = 0x1234;
  writeGrayPng(folder / "a.png", image);
  EXPECT_EQ(readGrayImage(folder / "a.png"), image);
}

TEST(ImageIo, EightBitGreyReadsAsTheSameNumbers) {
  TemporaryFolder folder;
  Image<std::uint8_t> image(3, 1);
  image(1, 0) = 200;
  writeGrayPng(folder / "a.png", image);
  const Image<std::uint16_t> read = readGrayImage(folder / "a.png");
  EXPECT_EQ(read(0, 0), 0);
  EXPECT_EQ(read(1, 0), 200);
}

// The files below tests/data/images were written by other programs (ImageMagick-like tools), never
// by this code.
TEST(ImageIo, ForeignSixteenBitFileIsBigEndian) {
  const Image<std::uint16_t> image = readGrayImage(kData / "gray16_2x2.png");
  ASSERT_EQ(image.width(), 2);
  EXPECT_EQ(image(0, 0), 1);
  EXPECT_EQ(image(1, 0), 258);
  EXPECT_EQ(image(0, 1), 40000);
  EXPECT_EQ(image(1, 1), 65535);
}

TEST(ImageIo, EveryKindOfPngReadsAsColor) {
  const Rgb red{255, 0, 0};
  const Rgb teal{0, 128, 128};
  for (const char* name : {"rgb8_2x1.png", "rgba8_2x1.png", "palette_2x1.png", "rgb16_2x1.png",
                           "interlaced_2x1.png"}) {
    const Image<Rgb> image = readColorImage(kData / name);
    ASSERT_EQ(image.width(), 2) << name;
    EXPECT_EQ(image(0, 0), red) << name;
    EXPECT_EQ(image(1, 0), teal) << name;
  }
  const Image<Rgb> grey = readColorImage(kData / "gray16_2x2.png");
  EXPECT_EQ(grey(1, 1), (Rgb{255, 255, 255}));
}

TEST(ImageIo, JpegReadsAsColor) {
  const Image<Rgb> image = readColorImage(kData / "orange_16x8.jpg");
  ASSERT_EQ(image.width(), 16);
  ASSERT_EQ(image.height(), 8);
  EXPECT_NEAR(image(8, 4).r, 250, 3);
  EXPECT_NEAR(image(8, 4).g, 140, 3);
  EXPECT_NEAR(image(8, 4).b, 20, 3);
}

TEST(ImageIo, TruncatedPngIsOneLineNamingTheFileAtEveryLength) {
  TemporaryFolder folder;
  writeColorPng(folder / "a.png", picture(40, 30));
  const std::string bytes = readFile(folder / "a.png");
  for (std::size_t length = 8; length < bytes.size(); length += 37) {
    writeText(folder / "cut.png", bytes.substr(0, length));
    const std::string message = messageOf<InputError>([&] { readColorImage(folder / "cut.png"); });
    EXPECT_THAT(message, HasSubstr("cut.png: broken or truncated PNG: the file ends early"));
    EXPECT_THAT(message, Not(HasSubstr("\n")));
  }
}

TEST(ImageIo, DamagedPngIsReported) {
  TemporaryFolder folder;
  writeColorPng(folder / "a.png", picture(40, 30));
  std::string bytes = readFile(folder / "a.png");
  bytes[bytes.size() / 2] = static_cast<char>(bytes[bytes.size() / 2] ^ 0x55);
  writeText(folder / "bad.png", bytes);
  EXPECT_THAT(messageOf<InputError>([&] { readColorImage(folder / "bad.png"); }),
              HasSubstr("bad.png: broken or truncated PNG"));
}

TEST(ImageIo, TruncatedJpegIsReportedInsteadOfFilledWithGrey) {
  TemporaryFolder folder;
  const std::string bytes = readFile(kData / "orange_16x8.jpg");
  for (const std::size_t cut : {bytes.size() / 2, bytes.size() - 8, bytes.size() - 2}) {
    writeText(folder / "cut.jpg", bytes.substr(0, cut));
    EXPECT_THAT(messageOf<InputError>([&] { readColorImage(folder / "cut.jpg"); }),
                HasSubstr("cut.jpg: broken or truncated JPEG"))
        << cut;
  }
}

TEST(ImageIo, ForeignContentIsReportedWhateverTheName) {
  TemporaryFolder folder;
  writeText(folder / "a.png", "not an image");
  EXPECT_EQ(messageOf<InputError>([&] { readColorImage(folder / "a.png"); }),
            (folder / "a.png").string() + ": neither a PNG nor a JPEG");
  writeText(folder / "empty.png", "");
  EXPECT_THAT(messageOf<InputError>([&] { readGrayImage(folder / "empty.png"); }),
              HasSubstr("empty.png: not a PNG"));
}

TEST(ImageIo, IntegersAreNotTakenFromColorOrJpeg) {
  EXPECT_THAT(messageOf<InputError>([] { readGrayImage(kData / "rgb8_2x1.png"); }),
              HasSubstr("rgb8_2x1.png: PNG has 3 channel(s) of 8 bit, expected one grey channel"));
  EXPECT_THAT(messageOf<InputError>([] { readGrayImage(kData / "palette_2x1.png"); }),
              HasSubstr("palette_2x1.png: PNG has a palette"));
  EXPECT_THAT(messageOf<InputError>([] { readGrayImage(kData / "orange_16x8.jpg"); }),
              HasSubstr("is a JPEG, which alters values"));
}

TEST(ImageIo, HeaderThatClaimsMoreThanTheFileCanHoldIsReported) {
  // The header of a real file, with width and height patched to 100000 and its checksum made anew.
  TemporaryFolder folder;
  std::string bytes = readFile(kData / "gray16_2x2.png");
  const std::string size("\x00\x01\x86\xa0\x00\x01\x86\xa0", 8);
  bytes.replace(16, 8, size);
  std::uint32_t crc = 0xffffffffu;
  for (std::size_t i = 12; i < 29; ++i) {
    crc ^= static_cast<unsigned char>(bytes[i]);
    for (int bit = 0; bit < 8; ++bit) crc = (crc >> 1) ^ ((crc & 1) ? 0xedb88320u : 0u);
  }
  crc = ~crc;
  for (std::size_t i = 0; i < 4; ++i) bytes[29 + i] = static_cast<char>(crc >> (24 - 8 * i));
  writeText(folder / "huge.png", bytes);
  EXPECT_THAT(messageOf<InputError>([&] { readGrayImage(folder / "huge.png"); }),
              HasSubstr("huge.png: PNG header claims 100000 x 100000 pixels, but the file has"));
}

TEST(ImageIo, BytesDependOnThePixelsOnlyWhileManyThreadsWrite) {
  TemporaryFolder folder;
  const Image<Rgb> image = picture(120, 80);
  parallelFor(8, [&](std::size_t i) { writeColorPng(folder / fmt::format("{}.png", i), image); });
  const std::string first = readFile(folder / "0.png");
  for (int i = 1; i < 8; ++i) EXPECT_EQ(readFile(folder / fmt::format("{}.png", i)), first);
}

}  // namespace
}  // namespace hydrabench

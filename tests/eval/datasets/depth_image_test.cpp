// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/datasets/depth_image.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/types/error.h"
#include "tests/support/temporary_folder.h"

namespace hydrabench {
namespace {

using ::testing::HasSubstr;

TEST(DepthImage, EveryMultipleOfTheQuantumSurvives) {
  for (const double quantum_m : {0.001, 0.0001, 0.00025}) {
    Image<std::uint16_t> quanta(65536, 1);
    for (int i = 0; i < 65536; ++i) quanta(i, 0) = static_cast<std::uint16_t>(i);
    const auto back = quantaFromDepth(depthFromQuanta(quanta, quantum_m), quantum_m);
    ASSERT_TRUE(back.has_value()) << quantum_m;
    EXPECT_TRUE(*back == quanta) << quantum_m;
  }
}

TEST(DepthImage, WhatIsNoMultipleIsNotBentIntoOne) {
  EXPECT_FALSE(quantaFromDepth(Image<float>(1, 1, 0.0015f), 0.001));
  EXPECT_FALSE(quantaFromDepth(Image<float>(1, 1, 66.0f), 0.001)) << "beyond 16 bit";
  EXPECT_FALSE(quantaFromDepth(Image<float>(1, 1, -0.001f), 0.001));
  EXPECT_TRUE(quantaFromDepth(Image<float>(1, 1, 0.0f), 0.001));
}

TEST(DepthImage, FloatMapKeepsEveryBitAndTheOrderOfRows) {
  TemporaryFolder folder;
  Image<float> depth(3, 2);
  for (int i = 0; i < 6; ++i) depth.data()[i] = 1.0f / static_cast<float>(i + 3);
  writeDepthPfm(folder / "d.pfm", depth);
  EXPECT_TRUE(readDepthPfm(folder / "d.pfm") == depth);
  // The format stores rows from the bottom up: the first float is the first pixel of the last row.
  const std::string bytes = readText(folder / "d.pfm");
  EXPECT_EQ(bytes.substr(0, 12), "Pf\n3 2\n-1.0\n");
  float first = 0;
  std::copy(bytes.begin() + 12, bytes.begin() + 16, reinterpret_cast<char*>(&first));
  EXPECT_EQ(first, depth(0, 1));
}

TEST(DepthImage, MalformedFloatMapsAreRefused) {
  TemporaryFolder folder;
  const auto fault = [&](const std::string& bytes) {
    writeText(folder / "d.pfm", bytes);
    return messageOf<InputError>([&] { readDepthPfm(folder / "d.pfm"); });
  };
  for (const char* bytes : {"", "Pf", "PF\n1 1\n-1.0\nabcd", "Pf\n1 1\n1.0\nabcd",
                            "Pf\n-1 1\n-1.0\nabcd", "Pf\n1 x\n-1.0\nabcd"}) {
    EXPECT_THAT(fault(bytes),
                HasSubstr("d.pfm: not a one-channel little-endian portable float map"))
        << bytes;
  }
  EXPECT_THAT(fault("Pf\n2 1\n-1.0\nabcd"),
              HasSubstr("d.pfm: 2 x 1 pixels need 8 bytes after the header, found 4"));
}

TEST(DepthImage, OneMeasuredPixelIsEnough) {
  Image<float> depth(3, 2);
  EXPECT_FALSE(hasDepth(depth));
  depth(2, 1) = 0.1f;
  EXPECT_TRUE(hasDepth(depth));
}

}  // namespace
}  // namespace hydrabench

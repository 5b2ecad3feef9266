// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "core/shape/sidecar/sidecar_message.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/types/error.h"

namespace hydrabench {
namespace {

SidecarMessage message() {
  SidecarMessage message;
  message.header = {{"op", "estimate"}, {"seed", 7}};
  message.blobs = {{"mask", "u1", {2, 3}, std::string("\0\1\0\1\1\0", 6)},
                   {"faces", "u4", {0, 3}, ""},
                   {"depth", "f4", {1, 2}, "\1\2\3\4\5\6\7\10"}};
  return message;
}

std::string faultOf(std::string_view bytes) {
  SidecarReader reader;
  reader.append(bytes);
  try {
    reader.next();
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

std::string framed(const std::string& header) {
  return std::string("S3D1") + static_cast<char>(header.size()) + std::string(3, '\0') + header;
}

TEST(SidecarMessage, IsMagicLengthHeaderAndBlobs) {
  SidecarMessage small;
  small.header = {{"a", 1}};
  small.blobs = {{"m", "u1", {2}, "xy"}};
  const std::string header = R"({"a":1,"blobs":[{"bytes":2,"dtype":"u1","name":"m","shape":[2]}]})";
  EXPECT_EQ(encode(small), framed(header) + "xy");
}

TEST(SidecarMessage, ComesBackWholeHoweverItIsCut) {
  const std::string bytes = encode(message()) + encode(message());
  for (const std::size_t piece : {1u, 7u, 64u, 1000u}) {
    SidecarReader reader;
    int whole = 0;
    for (std::size_t at = 0; at < bytes.size(); at += piece) {
      reader.append(std::string_view(bytes).substr(at, piece));
      while (const auto read = reader.next()) {
        ++whole;
        EXPECT_EQ(read->header, message().header);
        ASSERT_EQ(read->blobs.size(), 3u);
        EXPECT_EQ(read->find("mask")->bytes, message().blobs[0].bytes);
        EXPECT_EQ(read->find("depth")->shape, (std::vector<std::size_t>{1, 2}));
        EXPECT_EQ(read->find("nothing"), nullptr);
      }
    }
    EXPECT_EQ(whole, 2) << piece;
    EXPECT_TRUE(reader.empty());
  }
}

TEST(SidecarMessage, WhatIsNoMessageIsSaidInOneLine) {
  using ::testing::HasSubstr;
  EXPECT_THAT(faultOf("S3X"), HasSubstr("does not begin with 'S3D1'"));
  EXPECT_THAT(faultOf("Loading checkpoint\n"), HasSubstr("does not begin with 'S3D1'"));
  EXPECT_THAT(faultOf(std::string("S3D1\xff\xff\xff\xff")), HasSubstr("a header of 4294967295"));
  EXPECT_THAT(faultOf(framed("{\"blobs\":")), HasSubstr("a header is not as expected"));
  EXPECT_THAT(faultOf(framed("{}")), HasSubstr("a header is not as expected"));
  EXPECT_THAT(faultOf(framed("[]")), HasSubstr("a header is not as expected"));
  EXPECT_THAT(faultOf(framed(R"({"blobs":[{"name":"m","dtype":"f8","shape":[1],"bytes":8}]})")),
              HasSubstr("dtype 'f8', expected u1, u4 or f4"));
  EXPECT_THAT(faultOf(framed(R"({"blobs":[{"name":"m","dtype":"f4","shape":[2,3],"bytes":25}]})")),
              HasSubstr("blob 'm' states 25 bytes, expected 24"));
  EXPECT_THAT(
      faultOf(framed(
          R"({"blobs":[{"name":"m","dtype":"f4","shape":[4294967296,4294967296],"bytes":0}]})")),
      HasSubstr("blob 'm' is larger than"));
  EXPECT_THAT(faultOf(framed(R"({"blobs":[{"name":"m","dtype":"u1","shape":[-1],"bytes":1}]})")),
              HasSubstr("-1 for a length"));
  EXPECT_THAT(faultOf(framed(R"({"blobs":[{"name":"m","dtype":"u1","shape":[1],"bytes":1e300}]})")),
              HasSubstr("1e+300 for a length"));
}

}  // namespace
}  // namespace hydrabench

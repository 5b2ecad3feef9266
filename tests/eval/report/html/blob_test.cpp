// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/report/html/blob.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/types/error.h"

namespace hydrabench {
namespace {

TEST(Gzip, ComesBackAsItWas) {
  std::string bytes;
  for (unsigned i = 0; i < 200000; ++i) bytes += static_cast<char>(i * i / 7);
  EXPECT_EQ(gunzipped(gzipped(bytes)), bytes);
  EXPECT_EQ(gunzipped(gzipped("")), "");
  EXPECT_LT(gzipped(std::string(100000, 'a')).size(), 200u);
}

TEST(Gzip, ComplainsAboutATruncatedStream) {
  const std::string bytes = gzipped("enough text to be cut somewhere in its middle");
  EXPECT_THROW(gunzipped(std::string_view(bytes).substr(0, bytes.size() - 9)), InputError);
  EXPECT_THROW(gunzipped("no gzip"), InputError);
}

TEST(Base64, AgreesWithTheVectorsOfRfc4648) {
  EXPECT_EQ(base64(""), "");
  EXPECT_EQ(base64("f"), "Zg==");
  EXPECT_EQ(base64("fo"), "Zm8=");
  EXPECT_EQ(base64("foo"), "Zm9v");
  EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
  EXPECT_EQ(base64(std::string("\xff\xfe\x00", 3)), "//4A");
}

TEST(BlobPool, KeepsEqualPiecesOnce) {
  BlobPool pool;
  EXPECT_EQ(pool.add("shape").offset, 0u);
  EXPECT_EQ(pool.add("other").offset, 5u);
  EXPECT_EQ(pool.add("shape").offset, 0u);
  EXPECT_EQ(pool.bytes(), "shapeother");
}

}  // namespace
}  // namespace hydrabench

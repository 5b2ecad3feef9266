// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
// The build's way around missing programs, and what it leaves behind.
#include "eval/report/html/web_assets.h"

#include <cstdlib>
#include <filesystem>
#include <string>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/types/error.h"
#include "tests/support/temporary_folder.h"

namespace hydrabench {
namespace {

using ::testing::HasSubstr;

int bundle(const TemporaryFolder& folder, const std::string& npm, const std::string& esbuild) {
  return std::system(
      fmt::format("'{}' -DSOURCE='{}/eval/report/html/web' -DBUILD='{}' -DNPM={} "
                  "-DESBUILD={} -P '{}/eval/report/html/web_assets.cmake' > '{}' 2>&1",
                  HYDRABENCH_CMAKE, HYDRABENCH_SOURCE_DIR, (folder / "build").string(), npm,
                  esbuild, HYDRABENCH_SOURCE_DIR, (folder / "log").string())
          .c_str());
}

TEST(WebAssets, ABuildWithoutEsbuildSucceedsAndSaysWhatToDo) {
  const TemporaryFolder folder;
  EXPECT_EQ(bundle(folder, "/bin/true", ""), 0);
  EXPECT_THAT(readText(folder / "build/web_assets.cpp"),
              HasSubstr("built without HTML reports: esbuild was not found; install it "
                        "(scripts/setup does), configure and build again"));
}

TEST(WebAssets, ABuildWithoutNetworkSucceedsAndSaysWhatToDo) {
  const TemporaryFolder folder;
  EXPECT_EQ(bundle(folder, "/bin/false", "/bin/true"), 0);
  EXPECT_THAT(readText(folder / "build/web_assets.cpp"),
              HasSubstr("npm could not fetch its packages"));
}

TEST(WebAssets, NothingInTheScriptEndsItsElement) {
  try {
    const WebAssets assets = webAssets();
    EXPECT_EQ(assets.script.find("</script"), std::string_view::npos);
    EXPECT_EQ(assets.script.find("<!--"), std::string_view::npos);
    EXPECT_THAT(std::string(assets.licenses), HasSubstr("three 0.187.0"));
    EXPECT_THAT(std::string(assets.licenses), HasSubstr("uplot 1.6.32"));
  } catch (const InputError& error) {
    GTEST_SKIP() << error.what();
  }
}

}  // namespace
}  // namespace hydrabench

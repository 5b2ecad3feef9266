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
using ::testing::StartsWith;

int bundle(const TemporaryFolder& folder, const std::string& npm, const std::string& esbuild) {
  return std::system(
      fmt::format("'{}' -DSOURCE='{}/eval/report/html/web' -DBUILD='{}' -DNPM={} "
                  "-DESBUILD={} -P '{}/eval/report/html/web_assets.cmake' > '{}' 2>&1",
                  HYDRABENCH_CMAKE, HYDRABENCH_SOURCE_DIR, (folder / "build").string(), npm,
                  esbuild, HYDRABENCH_SOURCE_DIR, (folder / "log").string())
          .c_str());
}

/// A program that only says its version.
std::string esbuildOf(const TemporaryFolder& folder, const std::string& version) {
  const std::filesystem::path program = folder / "esbuild";
  writeText(program, "#!/bin/sh\necho " + version + "\n");
  std::filesystem::permissions(program, std::filesystem::perms::owner_all);
  return program.string();
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
  EXPECT_EQ(bundle(folder, "/bin/false", esbuildOf(folder, "0.25.10")), 0);
  EXPECT_THAT(readText(folder / "build/web_assets.cpp"),
              HasSubstr("npm could not fetch its packages"));
}

TEST(WebAssets, AnEsbuildOlderThanAnyThatWasTriedIsNotUsed) {
  const TemporaryFolder folder;
  EXPECT_EQ(bundle(folder, "/bin/false", esbuildOf(folder, "0.9.1")), 0);
  EXPECT_THAT(readText(folder / "build/missing.txt"),
              HasSubstr("esbuild 0.9.1 is too old, 0.17 or later is needed"));
}

TEST(WebAssets, TheScriptSaysWhatItIsMadeOf) {
  try {
    EXPECT_THAT(std::string(webAssets().script.substr(0, 200)),
                StartsWith("/* Front end of hydrabench's reports with three 0.187.0, uplot 1.6.32, "
                           "bundled by esbuild 0."));
  } catch (const InputError& error) {
    GTEST_SKIP() << error.what();
  }
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

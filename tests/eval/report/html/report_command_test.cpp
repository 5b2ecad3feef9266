// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
// The report of a small world as a user makes it, and as a browser shows it.
#include <cstdlib>
#include <filesystem>
#include <string>
#include <sys/wait.h>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/types/error.h"
#include "eval/report/html/web_assets.h"
#include "tests/support/temporary_folder.h"

namespace hydrabench {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

bool succeeds(const std::string& command) { return std::system(command.c_str()) == 0; }

class ReportCommand : public ::testing::Test {
 protected:
  void SetUp() override {
    try {
      webAssets();
    } catch (const InputError& error) {
      GTEST_SKIP() << error.what();
    }
  }

  /// A result of small pictures, in the folder "result".
  void makeResult(const std::string& seeds) {
    const fs::path configs = fs::path(HYDRABENCH_SOURCE_DIR) / "configs";
    writeText(folder_ / "small.yaml",
              fmt::format("datasets:\n  - config: {0}/datasets/office_quick.yaml\n    seeds: {1}\n"
                          "    set: [camera.width_px=180, camera.height_px=120, camera.fx_px=104, "
                          "camera.fy_px=104, camera.cx_px=90, camera.cy_px=60]\n"
                          "methods:\n  - config: {0}/methods/hydra.yaml\n"
                          "  - config: {0}/methods/oracle_shape.yaml\n"
                          "evaluation: {{samples: 300, bootstrap_resamples: 20}}\n",
                          configs.string(), seeds));
    ASSERT_EQ(run("run small.yaml --out result"), 0) << readText(folder_ / "err.txt");
  }

  int run(const std::string& arguments) {
    const std::string line =
        fmt::format("cd '{0}' && HYDRABENCH_STORE='{0}/store' '{1}' {2} >out.txt 2>err.txt",
                    folder_.path().string(), HYDRABENCH_COMMAND, arguments);
    return WEXITSTATUS(std::system(line.c_str()));
  }

  TemporaryFolder folder_;
};

TEST_F(ReportCommand, KeepsToItsSizeByCoarserScenesAndSaysSo) {
  makeResult("[1]");
  ASSERT_EQ(run("report result --format html"), 0) << readText(folder_ / "err.txt");
  const std::string first = readText(folder_ / "result/report.html");
  ASSERT_EQ(run("report result --format html --out again.html"), 0);
  EXPECT_EQ(readText(folder_ / "again.html"), first);

  const double limit_mb = 0.85 * static_cast<double>(first.size()) / 1e6;
  ASSERT_EQ(run(fmt::format("report result --format html --out less.html --max-mb {}", limit_mb)),
            0)
      << readText(folder_ / "err.txt");
  EXPECT_LE(static_cast<double>(fs::file_size(folder_ / "less.html")), 1e6 * limit_mb);
  EXPECT_THAT(readText(folder_ / "err.txt"), HasSubstr("--max-mb raises that"));
}

TEST_F(ReportCommand, ShowsEverythingInABrowserWithoutNetwork) {
  const std::string chromium = std::getenv("CHROMIUM") ? std::getenv("CHROMIUM") : "chromium";
  for (const std::string& program : {chromium, std::string("node")}) {
    if (!succeeds(fmt::format("command -v {} >/dev/null", program))) {
      GTEST_SKIP() << program << " is not installed (scripts/setup --ci installs it)";
    }
  }
  makeResult("[1, 2]");
  writeText(folder_ / "claims.yaml", R"(claims:
  - name: best
    says: True shapes have the best box IoU
    source: Test
    needs: [{metric: b_iou, tau_m: 0.5, method: oracle_shape, better_than: [hydra]}]
  - name: worst
    says: True shapes have the worst box IoU
    source: Test
    needs: [{metric: b_iou, tau_m: 0.5, method: hydra, better_than: [oracle_shape]}]
  - name: other
    says: Something about a method that is not here
    source: Test
    needs: [{metric: f1, tau_m: 0.5, method: khronos, better_than: [hydra]}]
)");
  ASSERT_EQ(run("report result --format html --claims claims.yaml"), 0)
      << readText(folder_ / "err.txt");
  const std::string line =
      fmt::format("node '{}/tests/eval/report/html/look_at_report.mjs' {} '{}' '{}' > '{}' 2>&1",
                  HYDRABENCH_SOURCE_DIR, chromium, (folder_ / "result/report.html").string(),
                  HYDRABENCH_SCREENSHOTS, (folder_ / "look.txt").string());
  EXPECT_TRUE(succeeds(line)) << readText(folder_ / "look.txt");
}

}  // namespace
}  // namespace hydrabench

// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/report/html/html_report.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/types/error.h"
#include "eval/evaluation/score_row.h"
#include "eval/report/html/web_assets.h"
#include "eval/report/result_folder.h"
#include "eval/report/sweep_report.h"
#include "tests/support/temporary_folder.h"

namespace hydrabench {
namespace {

using ::testing::HasSubstr;

ScoreRow row(const std::string& method, double f1) {
  return {"office", "1", method, kAllMicro, "tau_m", 0.5, kMatchingOneToOne,
          "f1",     f1,  "",     {},        {},      1};
}

class HtmlReportTest : public ::testing::Test {
 protected:
  void SetUp() override {
    try {
      webAssets();
    } catch (const InputError& error) {
      GTEST_SKIP() << error.what();
    }
  }
  std::string page() { return htmlReport(folder_.path()).page; }
  /// Not HasSubstr: a failure would print the page.
  static bool has(const std::string& page, const std::string& text) {
    return page.find(text) != std::string::npos;
  }

  TemporaryFolder folder_;
};

TEST_F(HtmlReportTest, AResultWithoutPredictionsHasTablesAndASentenceForTheScene) {
  writeText(folder_ / "scores.csv", scoresCsv({row("hydra", 0.5), row("</script>", 0.25)}));
  const std::string text = page();
  EXPECT_TRUE(has(text, R"("name":"hydra","label":"Hydra")"));
  EXPECT_TRUE(has(text, "This folder holds no predictions"));
  EXPECT_TRUE(has(text, R"("name":"\u003c/script>")"));
  EXPECT_FALSE(has(text, R"("</script>")"));
}

TEST_F(HtmlReportTest, NothingIsFetched) {
  writeText(folder_ / "scores.csv", scoresCsv({row("hydra", 0.5)}));
  const std::string text = page();
  EXPECT_TRUE(has(text, "default-src 'none'"));
  EXPECT_FALSE(has(text, "<script src"));
  EXPECT_FALSE(has(text, "<link rel=\"stylesheet\""));
}

TEST_F(HtmlReportTest, ASweepHasItsPlotsAndItsTable) {
  const SweepScores sweep = {{{"voxel_size_m", "voxel size [m]"}},
                             {{{"0.1"}, {row("hydra", 0.5)}}, {{"0.2"}, {row("hydra", 0.25)}}}};
  writeText(folder_ / "scores.csv", sweepCsv(sweep));
  writeText(folder_ / "config.yaml",
            "axes:\n  - name: voxel_size_m\n    title: \"voxel size [m]\"\nexperiment:\n");
  const std::string text = page();
  EXPECT_TRUE(has(text, R"("points":[[0.1,0.5],[0.2,0.25]])"));
  EXPECT_TRUE(has(text, "Hydra, voxel_size_m 0.2"));
  EXPECT_TRUE(has(text, R"("x_label":"voxel size [m]")"));
}

TEST_F(HtmlReportTest, ClaimsAreJudgedWhereTheResultSaysAnythingToOne) {
  const std::string claim =
      "claims:\n  - {name: n, says: s, source: p, needs: [{type: scene, metric: hole_area, "
      "lower_is_better: true, method: hydra, better_than: [other]}]}\n";
  writeText(folder_ / "claims.yaml", claim);
  ScoreRow mine = row("hydra", 0.5);
  mine.metric = "hole_area";
  mine.ci95_low = 0.4;
  mine.ci95_high = 0.6;
  HtmlReportOptions options;
  options.claims = folder_ / "claims.yaml";
  writeText(folder_ / "scores.csv", scoresCsv({mine}));
  EXPECT_TRUE(has(htmlReport(folder_.path(), options).page, R"(id="claims">null<)"));

  ScoreRow other = mine;
  other.method = "other";
  other.value = 2;
  other.ci95_low = 1.9;
  other.ci95_high = 2.1;
  writeText(folder_ / "scores.csv", scoresCsv({mine, other}));
  const std::string text = htmlReport(folder_.path(), options).page;
  EXPECT_TRUE(has(text, R"("verdict": "holds")"));
  // A page that is handed on does not tell where it was made.
  EXPECT_FALSE(has(text, folder_.path().string()));
  EXPECT_TRUE(has(page(), R"(id="claims">null<)"));
}

TEST_F(HtmlReportTest, AFolderOfSomethingElseIsRefused) {
  try {
    page();
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("no result folder, expected scores.csv"));
  }
}

}  // namespace
}  // namespace hydrabench

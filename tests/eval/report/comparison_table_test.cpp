// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/report/comparison_table.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "core/types/error.h"

namespace hydrabench {
namespace {

ScoreRow score(const std::string& method, double threshold, const std::string& matching,
               const std::string& metric, std::optional<double> value) {
  return {"office", "1",   method, kAllMicro, "tau_m", threshold, matching,
          metric,   value, "",     {},        {},      88};
}

/// Precision at 0.2 m of the paper's Table I.
std::vector<ScoreRow> paperPrecision() {
  return {score("slideslam", 0.2, kMatchingExists, "precision", 7.0 / 34),
          score("hydra", 0.2, kMatchingExists, "precision", 36.0 / 68),
          score("khronos", 0.2, kMatchingExists, "precision", 25.0 / 69),
          score("hydra_plus_plus_no_rmcc", 0.2, kMatchingExists, "precision", 75.0 / 112),
          score("hydra_plus_plus", 0.2, kMatchingExists, "precision", 70.0 / 89)};
}

TEST(ComparisonTable, RanksTheBestThreeAsThePaperShadesThem) {
  const ComparisonTable table = comparisonTable(paperPrecision());
  ASSERT_EQ(table.blocks.size(), 1u);
  std::vector<int> ranks;
  for (const TableRow& row : table.blocks[0].rows) ranks.push_back(row.cells[0].rank);
  EXPECT_EQ(ranks, (std::vector<int>{0, 3, 0, 2, 1}));
}

TEST(ComparisonTable, RanksSmallerDistancesHigher) {
  const ComparisonTable table =
      comparisonTable({score("a", 0.2, kMatchingExists, "chamfer_sq", 0.004),
                       score("b", 0.2, kMatchingExists, "chamfer_sq", 0.008)});
  EXPECT_EQ(table.blocks[0].rows[0].cells[3].rank, 1);
  EXPECT_EQ(table.blocks[0].rows[1].cells[3].rank, 2);
}

TEST(ComparisonTable, MarksCellsThatPrintTheSameTheSame) {
  const ComparisonTable table = comparisonTable({score("a", 0.2, kMatchingExists, "f1", 0.70001),
                                                 score("b", 0.2, kMatchingExists, "f1", 0.70002),
                                                 score("c", 0.2, kMatchingExists, "f1", 0.5)});
  EXPECT_EQ(table.blocks[0].rows[0].cells[2].rank, 1);
  EXPECT_EQ(table.blocks[0].rows[1].cells[2].rank, 1);
  EXPECT_EQ(table.blocks[0].rows[2].cells[2].rank, 2);
}

TEST(ComparisonTable, DoesNotRankRowsThatKnowTheGroundTruth) {
  const ComparisonTable table =
      comparisonTable({score("oracle_shape", 0.2, kMatchingExists, "f1", 0.9),
                       score("a", 0.2, kMatchingExists, "f1", 0.5)});
  EXPECT_EQ(table.blocks[0].rows[0].cells[2].rank, 0);
  EXPECT_EQ(table.blocks[0].rows[1].cells[2].rank, 1);
  EXPECT_NE(table.blocks[0].rows[0].label.find("bound"), std::string::npos);
}

TEST(ComparisonTable, SubtractsTheRowOfAMethod) {
  const ComparisonTable table =
      differencesTo(comparisonTable({score("a", 0.2, kMatchingExists, "f1", 0.5),
                                     score("a", 0.2, kMatchingExists, "truths", 88),
                                     score("b", 0.2, kMatchingExists, "f1", 0.75)}),
                    "a");
  EXPECT_EQ(table.blocks[0].rows[0].cells[2].value, 0.0);
  EXPECT_EQ(table.blocks[0].rows[1].cells[2].value, 0.25);
  EXPECT_EQ(table.blocks[0].rows[1].cells[0].value, std::nullopt);
  for (const TableColumn& column : table.columns) EXPECT_TRUE(column.ranked) << column.metric;
  EXPECT_THROW(differencesTo(table, "c"), InputError);
}

TEST(ComparisonTable, KeepsThresholdsAndMatchingsApart) {
  const ComparisonTable table = comparisonTable({score("a", 0.5, kMatchingOneToOne, "f1", 0.1),
                                                 score("a", 0.2, kMatchingExists, "f1", 0.2),
                                                 score("a", 0.5, kMatchingExists, "f1", 0.3)});
  ASSERT_EQ(table.blocks.size(), 3u);
  EXPECT_EQ(table.blocks[0].threshold, 0.2);
  EXPECT_EQ(table.blocks[1].matching, kMatchingExists);
  EXPECT_EQ(table.blocks[2].matching, kMatchingOneToOne);
}

TEST(ComparisonTable, PrefersPooledSeeds) {
  std::vector<ScoreRow> rows = {score("a", 0.2, kMatchingExists, "f1", 0.1),
                                score("a", 0.2, kMatchingExists, "f1", 0.2)};
  rows[1].seed = kPooledSeed;
  EXPECT_EQ(comparisonTable(rows).blocks[0].rows[0].cells[2].value, 0.2);
}

TEST(ComparisonTable, RefusesTwoSeedsThatClaimOneCell) {
  std::vector<ScoreRow> rows = {score("a", 0.2, kMatchingExists, "f1", 0.1),
                                score("a", 0.2, kMatchingExists, "f1", 0.2)};
  rows[1].seed = "2";
  EXPECT_THROW(comparisonTable(rows), InputError);
}

TEST(ComparisonTable, PrintsUndefinedAsNotAvailableAndNeverRanksIt) {
  const ComparisonTable table =
      comparisonTable({score("a", 0.2, kMatchingExists, "precision", std::nullopt)});
  EXPECT_EQ(table.blocks[0].rows[0].cells[0].rank, 0);
  EXPECT_NE(renderMarkdown(table).find("| a | n/a |"), std::string::npos);
  EXPECT_TRUE(nlohmann::json::parse(renderJson(table))["blocks"][0]["rows"][0]["precision"]["value"]
                  .is_null());
}

TEST(ComparisonTable, ShadesLatexCellsInThePapersColours) {
  const std::string latex = renderLatex(comparisonTable(paperPrecision()));
  EXPECT_NE(latex.find(R"(\cellcolor{hbfirst}\textbf{0.787})"), std::string::npos);
  EXPECT_NE(latex.find(R"(\cellcolor{hbsecond}0.670)"), std::string::npos);
  EXPECT_NE(latex.find(R"(\cellcolor{hbthird}0.529)"), std::string::npos);
  EXPECT_NE(latex.find(R"(\definecolor{hbfirst}{rgb}{0.753, 0.898, 0.804})"), std::string::npos);
  EXPECT_NE(latex.find(R"(\bottomrule)"), std::string::npos);
  EXPECT_EQ(latex.find("hit est."), std::string::npos);  // a page is only so wide
}

TEST(ComparisonTable, EscapesMethodNamesInLatex) {
  EXPECT_NE(renderLatex(comparisonTable({score("my_own", 0.2, kMatchingExists, "f1", 0.5)}))
                .find(R"(my\_own)"),
            std::string::npos);
}

TEST(ComparisonTable, AlignsTerminalColumnsDespiteArrows) {
  const std::string text = renderTerminal(comparisonTable(paperPrecision()), false);
  std::vector<std::size_t> ends;
  for (const char* number : {"0.206", "0.529", "0.787"}) {
    const std::size_t at = text.find(number);
    ASSERT_NE(at, std::string::npos);
    ends.push_back(at - text.rfind('\n', at));
  }
  EXPECT_EQ(ends[0], ends[1]);
  EXPECT_EQ(ends[1], ends[2]);
}

TEST(ComparisonTable, WritesIntervalsIntoTheCsv) {
  std::vector<ScoreRow> rows = {score("a", 0.2, kMatchingExists, "precision", 0.5)};
  rows[0].ci95_low = 0.25;
  rows[0].ci95_high = 0.75;
  EXPECT_NE(renderCsv(comparisonTable(rows)).find("0.2,exists,a,0.5,0.25,0.75,"),
            std::string::npos);
}

}  // namespace
}  // namespace hydrabench

// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/evaluation/csv.h"

#include <limits>

#include <gtest/gtest.h>

#include "core/types/error.h"
#include "eval/evaluation/score_row.h"
#include "tests/support/temporary_folder.h"

namespace hydrabench {
namespace {

ScoreRow sampleRow() {
  return {"office", "1",       "hydra", "chair", "tau_m", 0.2, kMatchingExists,
          "recall", 1.0 / 3.0, "",      0.1,     0.5,     88};
}

TEST(Csv, QuotesCommasQuotesAndLineBreaks) {
  EXPECT_EQ(csvLine({"plain", "a,b", "say \"x\"", "two\nlines", ""}),
            "plain,\"a,b\",\"say \"\"x\"\"\",\"two\nlines\",\n");
}

TEST(Csv, KeepsAnEmptyFirstCell) { EXPECT_EQ(csvLine({"", "x"}), ",x\n"); }

TEST(Csv, ReadsBackWhatItQuoted) {
  const TemporaryFolder folder;
  const std::vector<std::string> cells = {"a,b", "say \"x\"", "two\nlines"};
  writeText(folder / "t.csv", csvLine({"x", "y", "z"}) + csvLine(cells));
  EXPECT_EQ(readCsv(folder / "t.csv", {"x", "y", "z"}).rows.at(0), cells);
}

TEST(Csv, WritesNumbersThatReadBackTheSame) {
  for (const double value : {0.1, 1.0 / 3.0, 1e-300, -0.0, 123456789.123456789}) {
    EXPECT_EQ(std::stod(csvNumber(value)), value);
  }
  EXPECT_EQ(csvNumber(std::nullopt), "");
}

TEST(Csv, NamesTheLineWithTheWrongNumberOfColumns) {
  const TemporaryFolder folder;
  writeText(folder / "t.csv", "x,y\n1,2\n3\n");
  const std::string message = messageOf<InputError>([&] { readCsv(folder / "t.csv", {"x", "y"}); });
  EXPECT_EQ(message, (folder / "t.csv").string() + ":3: 1 columns, expected 2");
}

TEST(ScoreRows, SurviveTheFileUnchanged) {
  const TemporaryFolder folder;
  ScoreRow undefined = sampleRow();
  undefined.value = undefined.ci95_low = undefined.ci95_high = undefined.threshold = std::nullopt;
  writeText(folder / "scores.csv", scoresCsv({sampleRow(), undefined}));
  const std::vector<ScoreRow> rows = readScoresCsv(folder / "scores.csv");
  ASSERT_EQ(rows.size(), 2u);
  EXPECT_EQ(rows[0].value, 1.0 / 3.0);
  EXPECT_EQ(rows[0].n, 88u);
  EXPECT_EQ(rows[0].matching, kMatchingExists);
  EXPECT_EQ(rows[1].value, std::nullopt);
  EXPECT_EQ(scoresCsv(rows), readText(folder / "scores.csv"));
}

TEST(ScoreRows, WriteAnUndefinedValueAsAnEmptyField) {
  ScoreRow row = sampleRow();
  row.value = std::nullopt;
  EXPECT_NE(scoresCsv({row}).find("recall,,,0.1,0.5,88"), std::string::npos);
}

TEST(ScoreRows, NameFileLineAndColumnOfABadNumber) {
  const TemporaryFolder folder;
  std::string text = scoresCsv({sampleRow()});
  text.replace(text.find("0.333"), 5, "nan,3");
  writeText(folder / "scores.csv", text);
  EXPECT_THROW(readScoresCsv(folder / "scores.csv"), InputError);

  text = scoresCsv({sampleRow()});
  text.replace(text.find("0.3333"), 6, "twelve");
  writeText(folder / "scores.csv", text);
  const std::string message = messageOf<InputError>([&] { readScoresCsv(folder / "scores.csv"); });
  EXPECT_NE(message.find("scores.csv:2: value: 'twelve"), std::string::npos) << message;
}

}  // namespace
}  // namespace hydrabench

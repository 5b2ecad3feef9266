// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/audit/published_table.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/types/error.h"
#include "tests/support/temporary_folder.h"

namespace hydrabench {
namespace {

using ::testing::HasSubstr;

class PublishedTable : public ::testing::Test {
 protected:
  std::vector<PublishedRow> read(const std::string& name, const std::string& text) {
    writeText(folder_ / name, text);
    return readPublishedTable(folder_ / name);
  }
  std::string fault(const std::string& name, const std::string& text) {
    return messageOf<InputError>([&] { read(name, text); });
  }

  TemporaryFolder folder_;
};

TEST_F(PublishedTable, ReadsCsvWithItsDigits) {
  const auto rows =
      read("t.csv", "tau,Method,Precision,Recall,F1,extra\n0.2 m,A,.787,0.59,0.7,x\n");
  ASSERT_EQ(rows.size(), 1u);
  EXPECT_EQ(rows[0].group, "0.2 m");
  EXPECT_EQ(rows[0].method, "A");
  EXPECT_DOUBLE_EQ(rows[0].precision.value, 0.787);
  EXPECT_DOUBLE_EQ(rows[0].precision.unit, 0.001);
  EXPECT_DOUBLE_EQ(rows[0].recall.unit, 0.01);
  EXPECT_DOUBLE_EQ(rows[0].f1.unit, 0.1);
}

TEST_F(PublishedTable, ReadsLatexWithGroupsAndColours) {
  const auto rows = read("t.tex", R"(\begin{table}\begin{tabular}{l|l|ccc|c}\toprule
    & Method & {P\,$\uparrow$} & {R\,$\uparrow$} & F$_1$\,$\uparrow$ & Chamf. \\ \midrule
    \multirow{2}{*}{\rotatebox{90}{$\tau_d = 0.2$\,m}}
    & Hydra & \third 0.529 & 0.409 & 0.461 & 0.035 \\
    % & Old & 0.1 & 0.1 & 0.1 & 0.1 \\
    & Ours w/o \RMCC & \textbf{0.670} & 0.602 & 0.634 & 0.008 \\ \midrule
    \multirow{2}{*}{0.5}
    & Hydra & 0.897 & 0.705 & 0.789 & 0.072 \\ \bottomrule
    \end{tabular}\end{table})");
  ASSERT_EQ(rows.size(), 3u);
  EXPECT_EQ(rows[0].group, "tau_d = 0.2 m");
  EXPECT_EQ(rows[1].group, "tau_d = 0.2 m");
  EXPECT_EQ(rows[2].group, "0.5");
  EXPECT_EQ(rows[1].method, "Ours w/o RMCC");
  EXPECT_DOUBLE_EQ(rows[1].precision.value, 0.67);
  EXPECT_DOUBLE_EQ(rows[1].precision.unit, 0.001);
}

TEST_F(PublishedTable, TakesPerCentForTheWholeTable) {
  const auto rows = read("t.csv", "method,P,R,F1\nA,78.7,59.1,67.5\nB,0.5,0.9,0.6\n");
  ASSERT_EQ(rows.size(), 2u);
  EXPECT_DOUBLE_EQ(rows[0].precision.value, 0.787);
  EXPECT_DOUBLE_EQ(rows[0].precision.unit, 0.001);
  EXPECT_DOUBLE_EQ(rows[1].precision.value, 0.005);
}

TEST_F(PublishedTable, TakesTheValueOfValueAndDeviation) {
  const auto rows = read("t.csv", "method,P,R,F1\nA,0.78 ± 0.02,0.5 (0.4-0.6),0.6\n");
  ASSERT_EQ(rows.size(), 1u);
  EXPECT_DOUBLE_EQ(rows[0].precision.value, 0.78);
  EXPECT_DOUBLE_EQ(rows[0].recall.value, 0.5);
}

TEST_F(PublishedTable, PassesOverRowsWithoutScores) {
  EXPECT_EQ(read("t.csv", "method,P,R,F1\nindoor,,,\nA,0.5,0.5,0.5\nB,-,-,-\n").size(), 1u);
}

TEST_F(PublishedTable, NamesRowAndColumnOfAScoreThatIsMissing) {
  EXPECT_THAT(fault("t.csv", "method,P,R,F1\nA,0.5,n/a,0.5\n"),
              HasSubstr("t.csv: row 'A', column 'R': 'n/a', expected a number"));
  EXPECT_THAT(fault("t.csv", "method,P,R,F1\nA,0.5,0.5\n"), HasSubstr("column 'F1': ''"));
}

TEST_F(PublishedTable, SaysWhichColumnsItNeeds) {
  EXPECT_THAT(fault("t.csv", "method,P,R\nA,0.5,0.5\n"),
              HasSubstr("expected columns method, P, R and F1"));
  EXPECT_THAT(fault("t.tex", "no table"), HasSubstr("expected columns"));
  EXPECT_THAT(messageOf<InputError>([&] { readPublishedTable(folder_ / "absent.csv"); }),
              HasSubstr("absent.csv"));
}

}  // namespace
}  // namespace hydrabench

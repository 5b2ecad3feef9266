// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/audit/latex_table.h"

#include <gtest/gtest.h>

namespace hydrabench {
namespace {

using Table = std::vector<std::vector<std::string>>;

Table only(const std::string& source) {
  const std::vector<Table> tables = latexTables(source);
  EXPECT_EQ(tables.size(), 1u);
  return tables.empty() ? Table() : tables.front();
}

TEST(LatexTable, HasCellsOfRows) {
  EXPECT_EQ(only("\\begin{tabular}{l|c@{ }c}a&b\\\\c&d\\end{tabular}"),
            (Table{{"a", "b"}, {"c", "d"}}));
}

TEST(LatexTable, LeavesOutCommentsAndRules) {
  EXPECT_EQ(only("\\begin{tabular}{ll}\\toprule a&b\\\\\\cmidrule(lr){1-2}% old & row \\\\\n"
                 "5\\%&d\\end{tabular}"),
            (Table{{" a", "b"}, {" 5%", "d"}}));
}

TEST(LatexTable, KeepsTheTextOfBoxesAndStyles) {
  EXPECT_EQ(only("\\multirow{5}{*}{\\rotatebox[origin=c]{90}{$\\tau_d = 0.2$\\,m}}&"
                 "\\textbf{0.602}&\\multicolumn{2}{c}{x}&{\\color{red}y}"),
            (Table{{"tau_d = 0.2 m", "0.602", "x", "y"}}));
}

TEST(LatexTable, KeepsTheNamesOfMacros) {
  EXPECT_EQ(only("Ours w/o \\RMCC&\\first 0.8"), (Table{{"Ours w/o RMCC", "first 0.8"}}));
}

TEST(LatexTable, DoesNotSplitInsideAGroup) {
  EXPECT_EQ(only("\\parbox{2cm}{a \\& b & c}&d"), (Table{{"a & b & c", "d"}}));
}

TEST(LatexTable, ReadsAllTablesOfADocument) {
  const std::vector<Table> tables = latexTables(
      "\\begin{tabular*}{\\linewidth}{ll}a&b\\end{tabular*} text & more \\\\ "
      "\\begin{tabular}[t]{l}c\\end{tabular}");
  ASSERT_EQ(tables.size(), 2u);
  EXPECT_EQ(tables[0], (Table{{"a", "b"}}));
  EXPECT_EQ(tables[1], (Table{{"c"}}));
}

TEST(LatexTable, SurvivesWhatIsCutOff) {
  EXPECT_EQ(latexTables("\\begin{tabular}{l").size(), 1u);
  EXPECT_EQ(latexTables("\\begin{tabular}").size(), 1u);
  EXPECT_EQ(latexTables("a\\").size(), 1u);
  EXPECT_EQ(latexTables("").size(), 1u);
}

}  // namespace
}  // namespace hydrabench

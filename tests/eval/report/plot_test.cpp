// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/report/plot.h"

#include <cstdlib>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/io/image_io.h"
#include "tests/support/temporary_folder.h"

namespace hydrabench {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

Plot smallPlot() {
  Plot plot;
  PlotPanel& panel = plot.panels.emplace_back();
  panel.x_label = std::string("kappa");
  panel.y_label = std::string("F1");
  panel.marks.push_back({0.5, std::string("here")});
  PlotCurve& steps = panel.curves.emplace_back();
  steps.label = std::string("with_underscore \"quoted\"");
  steps.steps = true;
  steps.points = {{0, 0.25}, {0.5, 0.75}};
  steps.band = {{0, 0.1, 0.4}, {1, 0.6, 0.9}};
  PlotCurve& line = panel.curves.emplace_back();
  line.label = std::string("line");
  line.points = {{0, 0}, {1, 1}};
  return plot;
}

TEST(Plot, DrawsAStepAsTwoCornersAndAsFarAsTheAxis) {
  // At 0.5 the function still is 0.25; it ends at the border with its last value.
  EXPECT_THAT(gnuplotScript(smallPlot(), "p"),
              HasSubstr("$curve_0_0 << EOD\n0 0.25\n0.5 0.25\n0.5 0.75\n1 0.75\nEOD\n"));
}

TEST(Plot, DrawsALineAsItIs) {
  EXPECT_THAT(gnuplotScript(smallPlot(), "p"), HasSubstr("$curve_0_1 << EOD\n0 0\n1 1\nEOD\n"));
}

TEST(Plot, TakesMarkupOutOfNames) {
  EXPECT_THAT(gnuplotScript(smallPlot(), "p"),
              HasSubstr(R"(title "with\\_underscore \"quoted\"")"));
}

TEST(Plot, IsDrawnAsPngAndSvg) {
  if (!canPlot()) GTEST_SKIP() << "gnuplot is not installed";
  const TemporaryFolder folder;
  EXPECT_EQ(drawPlot(smallPlot(), folder.path(), "small"), "");
  const Image<Rgb> picture = readColorImage(folder / "small.png");
  EXPECT_EQ(picture.width(), 720);
  EXPECT_THAT(readText(folder / "small.svg"), HasSubstr("<svg"));
  EXPECT_FALSE(std::filesystem::exists(folder / "small.log"));
}

Plot violins() {
  Plot plot;
  PlotPanel& panel = plot.panels.emplace_back();
  panel.title = std::string("indoors");
  panel.y_label = std::string("latency [ms]");
  panel.y_range = {1, 1000};
  panel.log_y = true;
  panel.violins = {{"fast", {2, 3, 4, 3, 3}}, {"slow_one", {200, 300}}, {"absent", {}}};
  return plot;
}

TEST(Plot, NamesViolinsBelowThemAndSaysWhichIsNotThere) {
  const std::string script = gnuplotScript(violins(), "v");
  EXPECT_THAT(script, HasSubstr("set logscale y"));
  EXPECT_THAT(script, HasSubstr(R"(set xtics ("fast" 1, "slow\\_one" 2, "absent" 3))"));
  EXPECT_THAT(script, HasSubstr("set label \"not available\" at 3,"));
  EXPECT_THAT(script, HasSubstr("$median_0_0 << EOD\n1 3\nEOD\n"));
  EXPECT_THAT(script, HasSubstr("$bar_0_1 << EOD\n2 200\n2 300\nEOD\n"));
  EXPECT_THAT(script, Not(HasSubstr("$violin_0_2")));
}

TEST(Plot, DrawsViolinsBesideEachOther) {
  if (!canPlot()) GTEST_SKIP() << "gnuplot is not installed";
  const TemporaryFolder folder;
  Plot plot = violins();
  plot.panels.push_back(smallPlot().panels[0]);  // and a panel of another kind
  EXPECT_EQ(drawPlot(plot, folder.path(), "violins"), "");
  EXPECT_EQ(readColorImage(folder / "violins.png").width(), 1440);
}

TEST(Plot, SaysWhatIsMissingAndLeavesTheScript) {
  const TemporaryFolder folder;
  const std::string path = std::getenv("PATH");
  setenv("PATH", folder.path().c_str(), 1);
  const std::string remark = drawPlot(smallPlot(), folder.path(), "small");
  setenv("PATH", path.c_str(), 1);
  EXPECT_THAT(remark, HasSubstr("gnuplot is not installed"));
  EXPECT_TRUE(std::filesystem::exists(folder / "small.gp"));
  EXPECT_FALSE(std::filesystem::exists(folder / "small.png"));
}

}  // namespace
}  // namespace hydrabench

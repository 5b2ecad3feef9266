// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/report/loss_plot.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "eval/report/plot.h"
#include "tests/support/temporary_folder.h"

namespace hydrabench {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

constexpr const char* kHeader =
    "phase,step,samples,learning_rate,nocs_error,sdf_l1,direct,code,val_nocs_error,val_sdf_l1,"
    "val_direct,flow,val_flow\n";

TEST(LossPlot, HasAPanelForEveryLossThatThereIs) {
  const TemporaryFolder folder;
  writeText(folder / "loss.csv", std::string(kHeader) +
                                     "decoder,1000,,,,0.5,,,,,,,\n"
                                     "decoder,2000,,,,0.25,,,,,,,\n"
                                     "network,1000,,,0.75,,,,,,,,\n"
                                     "network,2000,,,0.5,,,,0.625,,,,\n");
  const std::string missing = drawLosses(folder / "loss.csv");
  EXPECT_EQ(missing.empty(), canPlot()) << missing;
  const std::string script = readText(folder / "loss.gp");
  EXPECT_THAT(script, HasSubstr("$curve_0_0 << EOD\n1 0.5\n2 0.25\nEOD\n"));
  EXPECT_THAT(script, HasSubstr("$curve_1_0 << EOD\n1 0.75\n2 0.5\nEOD\n"));
  EXPECT_THAT(script, HasSubstr("$curve_1_1 << EOD\n2 0.625\nEOD\n"));
  EXPECT_THAT(script, Not(HasSubstr("$curve_2_0")));
}

TEST(LossPlot, TakesTheMeanOfNeighboursWhereThereAreMany) {
  const TemporaryFolder folder;
  std::string text = kHeader;
  for (int i = 1; i <= 160; ++i) {
    text +=
        "network," + std::to_string(1000 * i) + ",,," + (i % 2 ? "0.25" : "0.75") + ",,,,,,,,\n";
  }
  writeText(folder / "loss.csv", text);
  drawLosses(folder / "loss.csv");
  EXPECT_THAT(readText(folder / "loss.gp"), HasSubstr("$curve_0_0 << EOD\n1.5 0.5\n3.5 0.5\n"));
}

TEST(LossPlot, SaysWhyThereIsNone) {
  const TemporaryFolder folder;
  writeText(folder / "loss.csv", kHeader);
  EXPECT_THAT(drawLosses(folder / "loss.csv"), HasSubstr("loss.csv: too few lines for a plot"));
  writeText(folder / "loss.csv", "a,b\n");
  EXPECT_THAT(drawLosses(folder / "loss.csv"), HasSubstr("loss.csv"));
}

}  // namespace
}  // namespace hydrabench

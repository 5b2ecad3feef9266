// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/training/loss_file.h"

#include <gtest/gtest.h>

#include "tests/support/temporary_folder.h"

namespace hydrabench {
namespace {

constexpr const char* kHeader =
    "phase,step,samples,learning_rate,nocs_error,sdf_l1,direct,code,val_nocs_error,val_sdf_l1,"
    "val_direct,flow,val_flow\n";

TEST(LossFile, LeavesEmptyWhatAPhaseDoesNotKnow) {
  const TemporaryFolder folder;
  LossFile(folder / "loss.csv", "decoder", 0).line(50, {{"samples", 100}, {"sdf_l1", 0.25}});
  EXPECT_EQ(readText(folder / "loss.csv"), std::string(kHeader) + "decoder,50,100,,,0.25,,,,,,,\n");
}

TEST(LossFile, GoesOnAfterTheStepOfTheCheckpointAndForgetsWhatCameLater) {
  const TemporaryFolder folder;
  LossFile(folder / "loss.csv", "decoder", 0).line(50, {{"sdf_l1", 0.5}});
  {
    LossFile file(folder / "loss.csv", "network", 0);
    for (const int step : {50, 100, 150}) file.line(step, {{"nocs_error", step}});
  }
  LossFile(folder / "loss.csv", "network", 100).line(150, {{"nocs_error", 0.125}});
  EXPECT_EQ(readText(folder / "loss.csv"), std::string(kHeader) +
                                               "decoder,50,,,,0.5,,,,,,,\n"
                                               "network,50,,,50,,,,,,,,\n"
                                               "network,100,,,100,,,,,,,,\n"
                                               "network,150,,,0.125,,,,,,,,\n");
}

TEST(LossFile, BeginsAnewWithItsPhase) {
  const TemporaryFolder folder;
  for (const double loss : {0.5, 0.25}) {
    LossFile(folder / "loss.csv", "decoder", 0).line(50, {{"sdf_l1", loss}});
  }
  EXPECT_EQ(readText(folder / "loss.csv"), std::string(kHeader) + "decoder,50,,,,0.25,,,,,,,\n");
}

}  // namespace
}  // namespace hydrabench

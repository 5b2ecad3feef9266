// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/training/latent_flow_training.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/parallel/parallel_for.h"
#include "core/shape/crisp/torch_weights.h"
#include "core/shape/latent_flow/latent_flow_model.h"
#include "core/types/error.h"
#include "tests/eval/training/toy_flow.h"
#include "tests/support/temporary_folder.h"

namespace hydrabench {
namespace {

class LatentFlowTraining : public ::testing::Test {
 protected:
  LatentFlowTraining() {
    for (const char* name : {"through", "stopped", "next"}) {
      cacheToyFlowWorlds(folder_ / name / "worlds", config_);
    }
  }
  /// At most `max_steps` of any phase, then asks to stop.
  TrainingState trainFor(int max_steps, const std::string& name) {
    int steps = 0;
    return trainLatentFlow(
        config_, resolved_, folder_ / name,
        [&](const std::string& phase, int, int, const std::map<std::string, double>&) {
          steps += phase != "worlds";
        },
        [&] { return steps >= max_steps; });
  }
  std::string weights(const std::string& name) {
    return readText(folder_ / name / "model/weights.safetensors");
  }
  LatentFlowTrainingConfig config_ = toyFlowTraining();
  std::string resolved_ = "toy: 1\n";
  TemporaryFolder folder_;
};

constexpr int kAll = 1000000;

TEST_F(LatentFlowTraining, StoppedAfterAnyStepComesToTheSameWeightsAsOneThatGoesThrough) {
  ASSERT_EQ(trainFor(kAll, "through"), TrainingState::kFinished);
  int calls = 1;
  while (trainFor(2, "stopped") != TrainingState::kFinished && calls < 20) ++calls;
  EXPECT_EQ(calls, 5);  // 9 steps
  EXPECT_EQ(weights("through"), weights("stopped"));
  EXPECT_EQ(readText(folder_ / "through/loss.csv"), readText(folder_ / "stopped/loss.csv"));
}

TEST_F(LatentFlowTraining, DoesNotDependOnTheNumberOfThreads) {
  setNumThreads(1);
  trainFor(kAll, "through");
  setNumThreads(2);
  trainFor(kAll, "stopped");
  setNumThreads(0);
  EXPECT_EQ(weights("through"), weights("stopped"));
}

TEST_F(LatentFlowTraining, LeavesAModelThatAnEstimatorCanLoadAndThatALaterOneBeginsWith) {
  trainFor(kAll, "through");
  EXPECT_NO_THROW(loadLatentFlowModel(folder_ / "through/model", "cpu"));
  config_.start_from = folder_ / "through/model";
  for (FlowPhaseConfig* phase : {static_cast<FlowPhaseConfig*>(&config_.autoencoder),
                                 static_cast<FlowPhaseConfig*>(&config_.pose),
                                 static_cast<FlowPhaseConfig*>(&config_.shape)}) {
    phase->steps = 0;
  }
  ASSERT_EQ(trainFor(kAll, "next"), TrainingState::kFinished);
  EXPECT_EQ(weights("through"), weights("next"));
}

TEST_F(LatentFlowTraining, RefusesAFolderOfOtherSettings) {
  trainFor(1, "through");
  resolved_ = "toy: 2\n";
  EXPECT_THAT(messageOf<InputError>([&] { trainFor(1, "through"); }),
              ::testing::HasSubstr("belongs to a training with other settings"));
}

TEST_F(LatentFlowTraining, TakesOverTheEncoderOfASmallCrispModelOfTheSameSizes) {
  config_.view_encoder_from = HYDRABENCH_SOURCE_DIR "/configs/models/crisp_indoor";
  EXPECT_THAT(messageOf<InputError>([&] { trainFor(1, "through"); }),
              ::testing::HasSubstr("view_encoder_from"));
}

}  // namespace
}  // namespace hydrabench

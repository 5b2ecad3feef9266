// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/training/latent_flow_training_config.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/types/error.h"
#include "eval/simulation/campus_labels.h"
#include "eval/simulation/office_labels.h"
#include "tests/support/temporary_folder.h"

namespace hydrabench {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

LatentFlowTrainingConfig readConfig(const std::string& yaml) {
  ConfigReader reader(ConfigDocument::fromString(yaml, "training.yaml"));
  LatentFlowTrainingConfig config;
  read(reader, config);
  reader.finish();
  return config;
}

std::string faultOf(const std::string& yaml) {
  return messageOf<InputError>([&] { readConfig(yaml); });
}

TEST(LatentFlowTrainingConfig, KnowsEveryScoredClassAndComputersWhichCrispNeverSaw) {
  const LatentFlowTrainingConfig config;
  for (const LabelSpace& space : {officeLabelSpace(true), campusLabelSpace()}) {
    for (const LabelSpace::Entry& entry : space.entries) {
      if (!entry.is_scored) continue;
      ASSERT_EQ(config.class_weights.count(entry.name), 1u) << entry.name;
      EXPECT_GT(config.class_weights.at(entry.name), 0) << entry.name;
    }
  }
  EXPECT_GT(config.class_weights.at("computer"), 0);
}

TEST(LatentFlowTrainingConfig, ReadsNestedKeys) {
  const LatentFlowTrainingConfig config = readConfig(
      "rooms: {count: 3, frames: 7}\nstreets: {max_depth_m: 9}\nclass_weights: {tree: 2}\n"
      "network: {flow_dim: 64, flow_heads: 4}\nshape: {steps: 11, condition_dropout: 0.2}\n");
  EXPECT_EQ(config.rooms.count, 3);
  EXPECT_EQ(config.rooms.worlds.frames, 7);
  EXPECT_EQ(config.rooms.worlds.objects, "all");
  EXPECT_EQ(config.streets.worlds.world, "street");
  EXPECT_EQ(config.streets.worlds.max_depth_m, 9);
  EXPECT_EQ(config.class_weights.at("tree"), 2);
  EXPECT_EQ(config.network.flow_dim, 64);
  EXPECT_EQ(config.shape.steps, 11);
  EXPECT_EQ(config.shape.condition_dropout, 0.2);
}

TEST(LatentFlowTrainingConfig, NamesItsFaults) {
  EXPECT_THAT(faultOf("shape: {batch: 33}\n"),
              AllOf(HasSubstr("training.yaml:1"), HasSubstr("33 is no multiple of the 2 shards")));
  EXPECT_THAT(faultOf("class_weights: {sofa: 1}\n"), HasSubstr("sofa"));
  EXPECT_THAT(faultOf("rooms: {grid_frames: 0}\n"), HasSubstr("0 grids per shape"));
  EXPECT_THAT(faultOf("network: {view_heads: 5}\n"), HasSubstr("5 heads"));
}

TEST(LatentFlowTrainingConfig, TheShippedFileIsValid) {
  ConfigReader reader(
      ConfigDocument::fromFile(HYDRABENCH_SOURCE_DIR "/configs/training/latent_flow.yaml"));
  std::string model;
  reader.choice("model", model, {"latent_flow"});
  LatentFlowTrainingConfig config;
  read(reader, config);
  EXPECT_NO_THROW(reader.finish());
  EXPECT_EQ(model, "latent_flow");
}

}  // namespace
}  // namespace hydrabench

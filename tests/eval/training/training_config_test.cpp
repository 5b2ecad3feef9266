// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/types/error.h"
#include "eval/training/crisp_training_config.h"
#include "tests/support/temporary_folder.h"

namespace hydrabench {
namespace {

using ::testing::HasSubstr;

CrispTrainingConfig readConfig(const std::string& yaml) {
  ConfigReader reader(ConfigDocument::fromString(yaml, "t.yaml"));
  CrispTrainingConfig config;
  read(reader, config);
  reader.finish();
  return config;
}

std::string faultOf(const std::string& yaml) {
  return messageOf<InputError>([&] { readConfig(yaml); });
}

TEST(CrispTrainingConfig, TheShippedFilesAreValid) {
  for (const char* file : {"crisp_indoor", "crisp_outdoor"}) {
    ConfigReader reader(ConfigDocument::fromFile(
        std::string(HYDRABENCH_SOURCE_DIR "/configs/training/") + file + ".yaml"));
    CrispTrainingConfig config;
    read(reader, config);
    EXPECT_NO_THROW(reader.finish());
    double total = 0;
    for (const auto& [name, weight] : config.class_weights) total += weight;
    EXPECT_NEAR(total, 1, 1e-12);
    EXPECT_EQ(config.class_weights.size(), config.sdf_quantiles.size());
  }
}

TEST(CrispTrainingConfig, StreetsHaveClassesOfTheirOwn) {
  const CrispTrainingConfig street =
      readConfig("worlds: {world: street}\nclass_weights: {car: 2}\n");
  EXPECT_EQ(street.class_weights.at("car"), 2);
  EXPECT_EQ(street.class_weights.count("chair"), 0u);
  EXPECT_THAT(faultOf("worlds: {world: street}\nclass_weights: {chair: 2}\n"), HasSubstr("chair"));
  EXPECT_THAT(faultOf("class_weights: {car: 2}\n"), HasSubstr("car"));
}

TEST(CrispTrainingConfig, ReadsNestedKeys) {
  const CrispTrainingConfig config = readConfig(
      "worlds: {frames: 7, image_width_px: 90}\nclass_weights: {chair: 2}\n"
      "joint: {window_worlds: 3}\nvalidation_every_steps: 11\n");
  EXPECT_EQ(config.worlds.frames, 7);
  EXPECT_EQ(config.worlds.image_width, 90);
  EXPECT_EQ(config.class_weights.at("chair"), 2);
  EXPECT_EQ(config.class_weights.at("bin"), 0.2);
  EXPECT_EQ(config.joint.window, 3);
  EXPECT_EQ(config.validation_every, 11);
}

TEST(CrispTrainingConfig, ABatchHasToDivideIntoShardsAndADimIntoHeads) {
  EXPECT_THAT(faultOf("shards: 3\n"), HasSubstr("3 does not divide joint.batch"));
  EXPECT_THAT(faultOf("network: {dim: 100, heads: 3}\n"), HasSubstr("3 heads do not divide dim"));
}

TEST(CrispTrainingConfig, NamesAClassItDoesNotKnow) {
  EXPECT_THAT(faultOf("class_weights: {chairs: 1}\n"), HasSubstr("chair"));
  EXPECT_THAT(faultOf("sdf_quantiles: {chairs: 0.3}\n"), HasSubstr("chair"));
}

TEST(CrispTrainingConfig, ChoosesNoOtherSplitThanItsOwn) {
  EXPECT_THAT(faultOf("worlds: {split: evaluation}\n"), HasSubstr("split"));
}

}  // namespace
}  // namespace hydrabench

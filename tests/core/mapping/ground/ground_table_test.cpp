// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "core/mapping/ground/ground_table.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/types/error.h"

namespace hydrabench {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

GroundConfig readYaml(const std::string& yaml) {
  ConfigReader reader(ConfigDocument::fromString(yaml, "ground.yaml"));
  GroundConfig config;
  read(reader, config);
  reader.finish();
  return config;
}
std::string faultOf(const std::string& yaml) {
  try {
    readYaml(yaml);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(GroundTable, HasThreeSegmenters) {
  EXPECT_THAT(groundTypes(), ElementsAre("patchwork", "semantic", "none"));
  GroundConfig config;
  config.type = "ransac";
  EXPECT_THROW(makeGroundSegmenter(config, {}), InputError);
}

TEST(GroundTable, SettingsOfTheOthersMayStand) {
  const GroundConfig config = readYaml("type: none\npatchwork: {min_points: 20}\n");
  EXPECT_EQ(config.type, "none");
  EXPECT_EQ(config.patchwork.min_points, 20);
}

TEST(GroundTable, TheSensorSetsTheOtherDefaults) {
  EXPECT_EQ(readYaml("").patchwork.zones.min_range_m, 2.7);
  const GroundConfig config =
      readYaml("patchwork: {sensor: vlp16, zones: {max_range_m: 30}, fit: {iterations: 5}}\n");
  EXPECT_EQ(config.patchwork.zones.min_range_m, 1);
  EXPECT_EQ(config.patchwork.zones.max_range_m, 30);
  EXPECT_EQ(config.patchwork.fit.thickness_m, 0.075);
  EXPECT_EQ(config.patchwork.fit.iterations, 5);
}

TEST(GroundTable, FaultsNameTheKey) {
  EXPECT_THAT(faultOf("type: patchwrok"), HasSubstr("did you mean patchwork?"));
  EXPECT_THAT(faultOf("type: semantic"),
              HasSubstr("labels: empty, expected at least one name of a class that is ground"));
  EXPECT_THAT(faultOf("patchwork: {sensor: vlp32}"), HasSubstr("sensor"));
  EXPECT_THAT(faultOf("patchwork: {zones: {rings: [2, 4, 4]}}"),
              HasSubstr("rings: 3 numbers, expected 4, one per zone"));
  EXPECT_THAT(faultOf("patchwork: {zones: {sectors: [16, 0, 54, 32]}}"), HasSubstr("sectors"));
  EXPECT_THAT(faultOf("patchwork: {zones: {max_range_m: 2}}"),
              HasSubstr("max_range_m: 2 is not above min_range_m (2.7)"));
  EXPECT_THAT(faultOf("patchwork: {fit: {min_uprightness: 45}}"), HasSubstr("min_uprightness"));
  EXPECT_THAT(faultOf("patchwork: {min_pts: 5}"), HasSubstr("min_pts"));
}

TEST(GroundTable, EveryKeyOfPatchworkIsReadBack) {
  ConfigReader reader(ConfigDocument::fromString("patchwork: {sensor: vlp16}"));
  GroundConfig config;
  read(reader, config);
  reader.finish();
  ConfigReader second(ConfigDocument::fromString(reader.resolved()));
  GroundConfig copy;
  read(second, copy);
  second.finish();
  EXPECT_EQ(second.resolved(), reader.resolved());
}

}  // namespace
}  // namespace hydrabench

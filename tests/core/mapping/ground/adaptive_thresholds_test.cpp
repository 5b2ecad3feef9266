// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "core/mapping/ground/adaptive_thresholds.h"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

namespace hydrabench {
namespace {

TEST(MeanDeviation, DividesByOneLessThanTheNumberOfValues) {
  const auto result = meanDeviation(std::vector<double>{1, 2, 6});
  ASSERT_TRUE(result);
  EXPECT_DOUBLE_EQ(result->mean, 3);
  EXPECT_DOUBLE_EQ(result->deviation, std::sqrt((4.0 + 1 + 9) / 2));
  EXPECT_FALSE(meanDeviation(std::vector<double>{1}));
}

TEST(AdaptiveThresholds, StartAtTheHeightOfTheSensor) {
  const AdaptiveThresholds thresholds({});
  EXPECT_TRUE(thresholds.covers(3));
  EXPECT_FALSE(thresholds.covers(4));
  EXPECT_EQ(thresholds.elevation(2), 0);
  EXPECT_EQ(thresholds.flatness(2), 0);
  EXPECT_FALSE(thresholds.sensorHeight());
}

TEST(AdaptiveThresholds, MoveAsTheEquationsSay) {
  AdaptiveThresholds thresholds({});
  // Elevations -1.8, -1.6: mean -1.7, deviation sqrt(0.02). Flatness 0.001, 0.003: 0.002,
  // sqrt(2)/1000.
  for (const std::size_t ring : {0u, 1u}) {
    thresholds.store(ring, -1.8, 0.001);
    thresholds.store(ring, -1.6, 0.003);
  }
  EXPECT_EQ(thresholds.elevation(0), 0) << "not before the scan is over";
  thresholds.adapt();
  EXPECT_DOUBLE_EQ(thresholds.elevation(0), -1.7 + 3 * std::sqrt(0.02));
  EXPECT_DOUBLE_EQ(thresholds.elevation(1), -1.7 + 2 * std::sqrt(0.02));
  EXPECT_DOUBLE_EQ(thresholds.flatness(0), 0.002 + std::sqrt(2) / 1000);
  EXPECT_DOUBLE_EQ(thresholds.flatness(1), 0.002 + std::sqrt(2) / 1000);
  EXPECT_DOUBLE_EQ(thresholds.sensorHeight().value(), 1.7);
}

TEST(AdaptiveThresholds, ARingLearnsWithoutTheRingsInside) {
  AdaptiveThresholds thresholds({});
  thresholds.store(0, -1.7, 0.5);  // one sample is none
  thresholds.store(2, -1, 0.001);
  thresholds.store(2, -1, 0.001);
  thresholds.adapt();
  EXPECT_EQ(thresholds.elevation(0), 0);
  EXPECT_EQ(thresholds.flatness(0), 0);
  EXPECT_FALSE(thresholds.sensorHeight());
  EXPECT_DOUBLE_EQ(thresholds.elevation(2), -1);
  EXPECT_DOUBLE_EQ(thresholds.flatness(2), 0.001);
}

TEST(AdaptiveThresholds, ForgetWhatIsBeyondTheStorage) {
  AdaptiveThresholds thresholds({.storage = 2});
  for (const double elevation : {-9.0, -2.0, -2.0}) thresholds.store(1, elevation, 0);
  thresholds.adapt();
  EXPECT_LT(thresholds.elevation(1), 5);
  EXPECT_GT(thresholds.elevation(1), -2) << "the first sample counted once";
  thresholds.adapt();
  EXPECT_DOUBLE_EQ(thresholds.elevation(1), -2);
}

TEST(AdaptiveThresholds, TheSensorIsNeverBelowTheGround) {
  AdaptiveThresholds thresholds({});
  for (int i = 0; i < 2; ++i) thresholds.store(0, 0.4, 0.01);
  thresholds.adapt();
  EXPECT_FALSE(thresholds.sensorHeight());
  AdaptiveThresholds fixed({.adapt_sensor_height = false});
  for (int i = 0; i < 2; ++i) fixed.store(0, -1.7, 0.01);
  fixed.adapt();
  EXPECT_FALSE(fixed.sensorHeight());
}

}  // namespace
}  // namespace hydrabench

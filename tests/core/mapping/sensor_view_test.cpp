// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "core/mapping/sensor_view.h"

#include <limits>

#include <gtest/gtest.h>

#include "core/parallel/parallel_for.h"

namespace hydrabench {
namespace {

/// Pixel (u, v) looks along (u - 20, v - 10, 10), so that (20 + 0, 10) looks straight ahead.
Frame frameOfDepth(float depth) {
  Frame frame;
  frame.camera = {41, 21, 10, 10, 20, 10};
  frame.depth = Image<float>(41, 21, depth);
  return frame;
}

TEST(SensorView, TurnsDepthIntoRangeAlongTheRay) {
  const SensorView view = sensorView(frameOfDepth(2), 0.1, 100);
  EXPECT_FLOAT_EQ(view.range(20, 10), 2);
  EXPECT_FLOAT_EQ(view.range(30, 10), 2 * std::sqrt(2.0f));  // (10, 0, 10) / 10
  EXPECT_FLOAT_EQ(view.range(40, 20), 2 * std::sqrt(6.0f));  // (20, 10, 10) / 10
  EXPECT_FLOAT_EQ(view.max_measured_m, 2 * std::sqrt(6.0f));
}

TEST(SensorView, DropsWhatIsTooNearAndKeepsWhatIsTooFarForCarving) {
  Frame frame = frameOfDepth(2);
  frame.depth(20, 10) = 0.5f;
  const SensorView view = sensorView(frame, 1, 3);
  EXPECT_EQ(view.range(20, 10), 0);                          // 0.5 m
  EXPECT_FLOAT_EQ(view.range(30, 10), 2 * std::sqrt(2.0f));  // 2.83 m
  EXPECT_FLOAT_EQ(view.range(40, 10), 2 * std::sqrt(5.0f));  // 4.47 m
  EXPECT_EQ(view.max_range_m, 3);
}

TEST(SensorView, PassesOverDepthsThatAreNoMeasurement) {
  Frame frame = frameOfDepth(0);
  frame.depth(1, 1) = std::numeric_limits<float>::quiet_NaN();
  frame.depth(2, 1) = std::numeric_limits<float>::infinity();
  frame.depth(3, 1) = -2;
  const SensorView view = sensorView(frame, 0.1, 5);
  for (const float range : view.range) EXPECT_EQ(range, 0);
  EXPECT_EQ(view.max_measured_m, 0);
}

TEST(SensorView, PointsToTheImagesThereAre) {
  Frame frame = frameOfDepth(1);
  frame.color = Image<Rgb>(41, 21);
  frame.stamp_ns = 7;
  const SensorView view = sensorView(frame, 0.1, 5);
  EXPECT_EQ(view.color, &frame.color);
  EXPECT_EQ(view.labels, nullptr);
  EXPECT_EQ(view.mask, nullptr);
  EXPECT_EQ(view.stamp_ns, 7);
}

TEST(RangeTiles, HoldTheExtremesOfTheirPixels) {
  Frame frame = frameOfDepth(2);
  frame.depth(9, 3) = 1;    // in the tile (1, 0)
  frame.depth(40, 20) = 0;  // in the last tile
  SensorView view = sensorView(frame, 0.1, 100);
  const RangeTiles::Bounds first = view.tiles.over(8, 0, 15, 7);
  EXPECT_EQ(first.min, view.range(9, 3));
  EXPECT_EQ(first.max, view.range(8, 0));
  EXPECT_EQ(view.tiles.over(39, 19, 40, 20).min, 0);
  EXPECT_EQ(view.tiles.over(0, 0, 40, 20).max, view.max_measured_m);

  view.range.fill(1.5f);
  summarizeRange(view);
  EXPECT_EQ(view.max_measured_m, 1.5f);
  EXPECT_EQ(view.tiles.over(0, 0, 40, 20).min, 1.5f);
}

TEST(SensorView, DoesNotDependOnTheNumberOfThreads) {
  Frame frame = frameOfDepth(2);
  for (int v = 0; v < 21; ++v)
    for (int u = 0; u < 41; ++u) frame.depth(u, v) = 1 + 0.01f * static_cast<float>(u * v % 97);
  const SensorView any = sensorView(frame, 0.1, 5);
  setNumThreads(1);
  const SensorView one = sensorView(frame, 0.1, 5);
  setNumThreads(0);
  EXPECT_EQ(any.range, one.range);
  EXPECT_EQ(any.max_measured_m, one.max_measured_m);
}

}  // namespace
}  // namespace hydrabench

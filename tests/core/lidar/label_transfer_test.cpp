// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "core/lidar/label_transfer.h"

#include <gtest/gtest.h>

namespace hydrabench {
namespace {

Frame halfAndHalf() {
  Frame frame;
  frame.camera = {100, 80, 100, 100, 50, 40};
  frame.labels = Image<Label>(100, 80, 3);
  for (int v = 0; v < 80; ++v) {
    for (int u = 50; u < 100; ++u) frame.labels(u, v) = 7;
  }
  return frame;
}

const std::vector<Eigen::Vector3f> kPoints = {{-0.5f, 0, 2}, {0.5f, 0, 2}, {0, 0, -2}};

TEST(LabelTransfer, GivesPointsTheClassOfTheirPixel) {
  EXPECT_EQ(labelsFromImage(halfAndHalf(), kPoints, Transform::Identity(), {}),
            (std::vector<Label>{3, 7, kUnknownLabel}));
}

TEST(LabelTransfer, TakesThePosesOfBothSensors) {
  Frame frame = halfAndHalf();
  frame.T_world_camera.translation().x() = 11;
  Transform T_world_points = Transform::Identity();
  T_world_points.translation().x() = 10;  // everything appears 1 m farther left
  EXPECT_EQ(labelsFromImage(frame, kPoints, T_world_points, {}),
            (std::vector<Label>{kUnknownLabel, 3, kUnknownLabel}));
}

TEST(LabelTransfer, DistrustsPixelsWhereTheCameraSawSomethingElse) {
  Frame frame = halfAndHalf();
  frame.depth = Image<float>(100, 80, 1.5f);
  frame.depth(75, 40) = 0;  // not measured: nothing speaks against it
  EXPECT_EQ(labelsFromImage(frame, kPoints, Transform::Identity(), {}),
            (std::vector<Label>{kUnknownLabel, 7, kUnknownLabel}));
}

TEST(LabelTransfer, KnowsNothingWithoutALabelImage) {
  Frame frame = halfAndHalf();
  frame.labels = {};
  EXPECT_EQ(labelsFromImage(frame, kPoints, Transform::Identity(), {}),
            (std::vector<Label>(3, kUnknownLabel)));
}

}  // namespace
}  // namespace hydrabench

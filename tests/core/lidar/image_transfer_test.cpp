// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "core/lidar/image_transfer.h"

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

TEST(ImageTransfer, GivesPointsTheClassOfTheirPixel) {
  EXPECT_EQ(looksFromImage(halfAndHalf(), kPoints, Transform::Identity(), {}).labels,
            (std::vector<Label>{3, 7, kUnknownLabel}));
}

TEST(ImageTransfer, TakesThePosesOfBothSensors) {
  Frame frame = halfAndHalf();
  frame.T_world_camera.translation().x() = 11;
  Transform T_world_points = Transform::Identity();
  T_world_points.translation().x() = 10;  // everything appears 1 m farther left
  EXPECT_EQ(looksFromImage(frame, kPoints, T_world_points, {}).labels,
            (std::vector<Label>{kUnknownLabel, 3, kUnknownLabel}));
}

TEST(ImageTransfer, DistrustsPixelsWhereTheCameraSawSomethingElse) {
  Frame frame = halfAndHalf();
  frame.depth = Image<float>(100, 80, 1.5f);
  frame.depth(75, 40) = 0;  // not measured: nothing speaks against it
  EXPECT_EQ(looksFromImage(frame, kPoints, Transform::Identity(), {}).labels,
            (std::vector<Label>{kUnknownLabel, 7, kUnknownLabel}));
}

TEST(ImageTransfer, GivesPointsTheColorOfTheirPixel) {
  Frame frame = halfAndHalf();
  frame.color = Image<Rgb>(100, 80, Rgb{1, 2, 3});
  const PointLooks looks = looksFromImage(frame, kPoints, Transform::Identity(), {});
  EXPECT_EQ(looks.colors[1], (Rgb{1, 2, 3}));
  EXPECT_EQ(looks.uncolored, (std::vector<std::uint8_t>{0, 0, 1}));
}

TEST(ImageTransfer, KnowsNothingWithoutALabelImage) {
  Frame frame = halfAndHalf();
  frame.labels = {};
  EXPECT_EQ(looksFromImage(frame, kPoints, Transform::Identity(), {}).labels,
            (std::vector<Label>(3, kUnknownLabel)));
}

}  // namespace
}  // namespace hydrabench

// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/view/frame_picture.h"

#include <set>
#include <tuple>

#include <gtest/gtest.h>

namespace hydrabench {
namespace {

TEST(FramePicture, PaintsMissingDepthBlack) {
  Image<float> depth(2, 1, 0.0f);
  depth(1, 0) = 2.0f;
  const Image<Rgb> picture = depthPicture(depth, 5);
  EXPECT_EQ(picture(0, 0), Rgb{});
  EXPECT_NE(picture(1, 0), Rgb{});
}

TEST(FramePicture, PaintsNearDepthRedAndFarDepthBlue) {
  Image<float> depth(2, 1, 0.8f);
  depth(1, 0) = 4.6f;
  const Image<Rgb> picture = depthPicture(depth, 5);
  EXPECT_GT(picture(0, 0).r, picture(0, 0).b);
  EXPECT_GT(picture(1, 0).b, picture(1, 0).r);
}

TEST(FramePicture, GivesDifferentInstancesDifferentColours) {
  Image<InstanceId> instances(200, 1);
  for (int i = 0; i < 200; ++i) instances(i, 0) = i;
  std::set<std::tuple<int, int, int>> colors;
  for (const Rgb& color : instancePicture(instances)) colors.emplace(color.r, color.g, color.b);
  EXPECT_GT(colors.size(), 190u);
}

TEST(FramePicture, PutsPicturesSideBySideWithAGap) {
  const Image<Rgb> red(2, 3, {255, 0, 0});
  const Image<Rgb> blue(4, 3, {0, 0, 255});
  const Image<Rgb> both = sideBySide({red, blue}, 1);
  EXPECT_EQ(both.width(), 7);
  EXPECT_EQ(both.height(), 3);
  EXPECT_EQ(both(1, 2), (Rgb{255, 0, 0}));
  EXPECT_EQ(both(2, 0), (Rgb{255, 255, 255}));
  EXPECT_EQ(both(6, 0), (Rgb{0, 0, 255}));
}

TEST(FramePicture, ReducesByTheMeanOfEachBlock) {
  Image<Rgb> picture(2, 2);
  picture(0, 0) = {0, 10, 255};
  picture(1, 0) = {100, 10, 255};
  picture(0, 1) = {0, 10, 255};
  picture(1, 1) = {100, 10, 255};
  EXPECT_EQ(reduced(picture, 2)(0, 0), (Rgb{50, 10, 255}));
}

TEST(FramePicture, LeavesOutImagesAFrameDoesNotHave) {
  Frame frame;
  frame.color = Image<Rgb>(4, 2);
  frame.depth = Image<float>(4, 2);
  EXPECT_EQ(framePicture(frame).width(), 4 + 4 + 4);
}

}  // namespace
}  // namespace hydrabench

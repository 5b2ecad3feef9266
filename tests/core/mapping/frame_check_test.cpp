// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "core/mapping/frame_check.h"

#include <limits>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/mapping/sensor_view.h"
#include "core/types/error.h"

namespace hydrabench {
namespace {

using testing::HasSubstr;

Frame smallFrame() {
  Frame frame;
  frame.stamp_ns = 42;
  frame.camera = {8, 6, 10, 10, 4, 3};
  frame.depth = Image<float>(8, 6, 1.0f);
  return frame;
}

/// What sensorView() has to say; empty: nothing.
std::string faultOf(const Frame& frame) {
  try {
    sensorView(frame, 0.1, 5);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(FrameCheck, ImagesOtherThanDepthMayBeMissing) {
  Frame frame = smallFrame();
  EXPECT_EQ(faultOf(frame), "");
  frame.color = Image<Rgb>(8, 6);
  frame.labels = Image<Label>(8, 6);
  frame.instances = Image<InstanceId>(8, 6);
  EXPECT_EQ(faultOf(frame), "");
}

TEST(FrameCheck, NamesTheFrameWithoutDepth) {
  Frame frame = smallFrame();
  frame.depth = {};
  EXPECT_EQ(faultOf(frame), "the frame at 42 ns has no depth image; expected 8 x 6 pixels");
}

TEST(FrameCheck, NamesTheImageOfTheWrongSize) {
  Frame frame = smallFrame();
  frame.depth = Image<float>(6, 8);  // as many pixels
  EXPECT_EQ(faultOf(frame),
            "the depth image of the frame at 42 ns has 6 x 8 pixels; expected 8 x 6, the size of "
            "its camera");
  frame = smallFrame();
  frame.color = Image<Rgb>(4, 3);
  EXPECT_THAT(faultOf(frame), HasSubstr("the color image of the frame at 42 ns has 4 x 3 pixels"));
  frame = smallFrame();
  frame.labels = Image<Label>(8, 5);
  EXPECT_THAT(faultOf(frame), HasSubstr("label image"));
  frame = smallFrame();
  frame.instances = Image<InstanceId>(9, 6);
  EXPECT_THAT(faultOf(frame), HasSubstr("instance image"));
}

TEST(FrameCheck, RefusesAPoseThatIsNotFinite) {
  Frame frame = smallFrame();
  frame.T_world_camera.translation().y() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(faultOf(frame), "the pose of the frame at 42 ns is not finite");
  frame = smallFrame();
  frame.T_world_camera.linear()(0, 0) = std::numeric_limits<double>::infinity();
  EXPECT_THAT(faultOf(frame), HasSubstr("not finite"));
}

TEST(FrameCheck, CellsAreNumberedUpToTwoToTheThirty) {
  const double last = 0.5 * (1 << 30);
  EXPECT_NO_THROW(requireInsideGrid(42, {0, -last, last}, 0.5));
  EXPECT_THROW(requireInsideGrid(42, {0, -last - 1, 0}, 0.5), InputError);
  EXPECT_THROW(requireInsideGrid(42, {0, 0, std::numeric_limits<double>::quiet_NaN()}, 0.5),
               InputError);
}

}  // namespace
}  // namespace hydrabench

// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "core/objects/frame_buffer.h"

#include <gtest/gtest.h>

#include "tests/core/objects/cell_camera.h"

namespace hydrabench {
namespace {

std::shared_ptr<const BufferedFrame> frameAt(std::int64_t stamp_ns) {
  return bufferedFrame(cellFrame(stamp_ns), Image<std::uint16_t>(16, 12));
}

TEST(FrameBuffer, TheOldestFrameGoesFirst) {
  FrameBuffer buffer(2);
  for (const std::int64_t stamp : {10, 20, 30}) buffer.add(frameAt(stamp));
  EXPECT_EQ(buffer.size(), 2u);
  EXPECT_EQ(buffer.find(10), nullptr);
  ASSERT_NE(buffer.find(20), nullptr);
  EXPECT_EQ(buffer.find(20)->stampNs(), 20);
}

TEST(FrameBuffer, FindsExactStampsOnly) {
  FrameBuffer buffer(5);
  buffer.add(frameAt(10));
  buffer.add(frameAt(20));
  EXPECT_EQ(buffer.find(15), nullptr);
  EXPECT_EQ(buffer.find(25), nullptr);
}

TEST(FrameBuffer, KeepsWhatIsReferredTo) {
  FrameBuffer buffer(5);
  for (const std::int64_t stamp : {10, 20, 30, 40}) buffer.add(frameAt(stamp));
  const auto held = buffer.find(30);
  buffer.keepOnly({5, 20, 40});
  EXPECT_EQ(buffer.size(), 2u);
  EXPECT_NE(buffer.find(20), nullptr);
  EXPECT_EQ(buffer.find(30), nullptr);
  EXPECT_EQ(held->stampNs(), 30);  // whoever works on a frame keeps it
  buffer.keepOnly({});
  EXPECT_EQ(buffer.size(), 0u);
}

TEST(BufferedFrame, HoldsCandidatesInPlaceOfLabels) {
  const auto kept = frameAt(10);
  EXPECT_EQ(kept->frame.depth(3, 3), kCellDepth);
  EXPECT_TRUE(kept->frame.labels.empty());
  EXPECT_TRUE(kept->frame.instances.empty());
  EXPECT_EQ(kept->ids.width(), 16);
}

}  // namespace
}  // namespace hydrabench

// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "core/objects/frame_buffer.h"

#include <algorithm>
#include <cassert>
#include <utility>

namespace hydrabench {

std::shared_ptr<const BufferedFrame> bufferedFrame(const Frame& frame, Image<std::uint16_t> ids) {
  auto kept = std::make_shared<BufferedFrame>();
  kept->frame.stamp_ns = frame.stamp_ns;
  kept->frame.camera = frame.camera;
  kept->frame.T_world_camera = frame.T_world_camera;
  kept->frame.color = frame.color;
  kept->frame.depth = frame.depth;
  kept->ids = std::move(ids);
  return kept;
}

void FrameBuffer::add(std::shared_ptr<const BufferedFrame> frame) {
  assert(frames_.empty() || frames_.back()->stampNs() < frame->stampNs());
  frames_.push_back(std::move(frame));
  if (frames_.size() > capacity_) frames_.pop_front();
}

std::shared_ptr<const BufferedFrame> FrameBuffer::find(std::int64_t stamp_ns) const {
  const auto it = std::lower_bound(
      frames_.begin(), frames_.end(), stamp_ns,
      [](const auto& frame, std::int64_t stamp) { return frame->stampNs() < stamp; });
  return it != frames_.end() && (*it)->stampNs() == stamp_ns ? *it : nullptr;
}

void FrameBuffer::keepOnly(const std::vector<std::int64_t>& stamps_ns) {
  assert(std::is_sorted(stamps_ns.begin(), stamps_ns.end()));
  std::erase_if(frames_, [&](const auto& frame) {
    return !std::binary_search(stamps_ns.begin(), stamps_ns.end(), frame->stampNs());
  });
}

}  // namespace hydrabench

// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <memory>
#include <vector>

#include "core/objects/object_candidate.h"
#include "core/types/frame.h"

namespace hydrabench {

/// A frame as it is kept for looking back: what reconstruction and shape estimation need of it.
struct BufferedFrame {
  Frame frame;               ///< without labels and instances: `ids` has what became of them
  Image<std::uint16_t> ids;  ///< of the candidates

  std::int64_t stampNs() const { return frame.stamp_ns; }
};

/// Copies what is kept of a frame.
std::shared_ptr<const BufferedFrame> bufferedFrame(const Frame& frame, Image<std::uint16_t> ids);

/// The last frames, at most `capacity`; the oldest goes first. Frames are shared, so that whoever
/// works on one keeps it.
class FrameBuffer {
 public:
  explicit FrameBuffer(std::size_t capacity) : capacity_(capacity) {}
  void add(std::shared_ptr<const BufferedFrame> frame);  ///< stamps must ascend
  /// nullptr if it is gone.
  std::shared_ptr<const BufferedFrame> find(std::int64_t stamp_ns) const;
  /// Drops every frame whose stamp is not listed (ascending).
  void keepOnly(const std::vector<std::int64_t>& stamps_ns);
  std::size_t size() const { return frames_.size(); }

 private:
  std::size_t capacity_;
  std::deque<std::shared_ptr<const BufferedFrame>> frames_;
};

}  // namespace hydrabench

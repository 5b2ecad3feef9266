// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "core/mapping/frame_check.h"

#include <fmt/format.h>

#include "core/types/error.h"

namespace hydrabench {
namespace {

template <typename Pixel>
void requireSize(const Frame& frame, const char* name, const Image<Pixel>& image) {
  const Camera& camera = frame.camera;
  if (image.empty() || (image.width() == camera.width && image.height() == camera.height)) return;
  throw InputError(fmt::format(
      "the {} image of the frame at {} ns has {} x {} pixels; expected {} x {}, the "
      "size of its camera",
      name, frame.stamp_ns, image.width(), image.height(), camera.width, camera.height));
}

}  // namespace

void requireUsable(const Frame& frame) {
  if (frame.depth.empty()) {
    throw InputError(fmt::format("the frame at {} ns has no depth image; expected {} x {} pixels",
                                 frame.stamp_ns, frame.camera.width, frame.camera.height));
  }
  requireSize(frame, "depth", frame.depth);
  requireSize(frame, "color", frame.color);
  requireSize(frame, "label", frame.labels);
  requireSize(frame, "instance", frame.instances);
  if (!frame.T_world_camera.matrix().allFinite()) {
    throw InputError(fmt::format("the pose of the frame at {} ns is not finite", frame.stamp_ns));
  }
}

void requireInsideGrid(std::int64_t stamp_ns, const Eigen::Vector3d& position, double cell_m) {
  constexpr double kMaxCells = 1 << 30;
  if ((position.array().abs() <= kMaxCells * cell_m).all()) return;
  throw InputError(fmt::format(
      "at {} ns: a position of ({:g}, {:g}, {:g}) m; expected at most {:g} m from the origin, so "
      "that cells of {:g} m can be numbered",
      stamp_ns, position.x(), position.y(), position.z(), kMaxCells * cell_m, cell_m));
}

}  // namespace hydrabench

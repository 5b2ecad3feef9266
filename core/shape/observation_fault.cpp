// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "core/shape/observation_fault.h"

#include <cmath>
#include <cstddef>

namespace hydrabench {
namespace {

constexpr const char* kBadCamera = "camera is not valid";
constexpr const char* kBadPose = "camera pose is not finite";
constexpr const char* kBadSizes = "image sizes differ";
constexpr const char* kNoColor = "no color image";
constexpr const char* kEmptyMask = "mask is empty";
constexpr const char* kLittleDepth = "fewer than 5 pixels with depth in the mask";

constexpr int kMinDepthPixels = 5;

template <typename Pixel>
bool hasSizeOf(const Camera& camera, const Image<Pixel>& image) {
  return image.width() == camera.width && image.height() == camera.height;
}

}  // namespace

const char* faultOf(const ShapeObservation& view, bool needs_color) {
  const Camera& camera = view.camera;
  const bool focal = camera.fx > 0 && camera.fy > 0;  // false for NaN
  if (camera.width <= 0 || camera.height <= 0 || !focal || !std::isfinite(camera.fx) ||
      !std::isfinite(camera.fy) || !std::isfinite(camera.cx) || !std::isfinite(camera.cy)) {
    return kBadCamera;
  }
  if (!view.T_world_camera.matrix().allFinite()) return kBadPose;
  if (!hasSizeOf(camera, view.mask) || !hasSizeOf(camera, view.depth)) return kBadSizes;
  if (!view.color.empty() && !hasSizeOf(camera, view.color)) return kBadSizes;
  if (needs_color && view.color.empty()) return kNoColor;
  int in_mask = 0;
  int with_depth = 0;
  for (std::size_t i = 0; i < view.mask.size(); ++i) {
    if (view.mask.data()[i] == 0) continue;
    ++in_mask;
    const float depth = view.depth.data()[i];
    if (depth > 0 && std::isfinite(depth)) ++with_depth;
  }
  if (in_mask == 0) return kEmptyMask;
  return with_depth < kMinDepthPixels ? kLittleDepth : nullptr;
}

}  // namespace hydrabench

// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <vector>

#include "core/geometry/camera.h"
#include "core/geometry/raycaster.h"
#include "core/types/image.h"
#include "eval/datasets/dataset.h"

namespace hydrabench {

/// Which ground-truth object each pixel of a view shows, on any dataset with meshes and true poses:
/// what the oracles know. Thread-safe.
class TrueInstances {
 public:
  static constexpr std::int32_t kNoObject = -1;

  explicit TrueInstances(const GroundTruth& truth);  ///< keeps a copy; meshes are shared

  const std::vector<GroundTruthObject>& objects() const { return objects_; }

  /// Where the camera truly was; `reported` where ground truth has no pose of that stamp.
  Transform cameraPose(std::int64_t stamp_ns, const Transform& reported) const;

  /// Index into objects() for each pixel; kNoObject where structure or nothing is in front.
  /// @param pixels  row-major indices
  std::vector<std::int32_t> objectsAt(const Camera& camera, const Transform& T_world_camera,
                                      std::span<const std::uint32_t> pixels) const;
  Image<std::int32_t> render(const Camera& camera, const Transform& T_world_camera) const;

  /// The object that most of these pixels show, of equals the first; nullopt where none shows one.
  std::optional<std::size_t> mostSeen(const Camera& camera, const Transform& T_world_camera,
                                      std::span<const std::uint32_t> pixels) const;

  /// Share of an object's surface that is in the image with nothing before it, by 400 points.
  double visibleFraction(std::size_t object, const Camera& camera,
                         const Transform& T_world_camera) const;

 private:
  std::vector<GroundTruthObject> objects_;
  std::map<std::int64_t, Transform> poses_;
  Raycaster object_surfaces_;  ///< mesh i is object i, world frame
  Raycaster world_;            ///< everything; the objects alone where there is no scene mesh
};

/// Row-major indices of the pixels of a mask.
std::vector<std::uint32_t> maskPixels(const Image<std::uint8_t>& mask);

/// The most frequent of some object indices, of equals the smallest; nullopt where all are
/// kNoObject.
std::optional<std::size_t> mostFrequentObject(std::span<const std::int32_t> objects);

}  // namespace hydrabench

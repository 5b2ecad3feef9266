// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "core/geometry/camera.h"
#include "core/geometry/mesh.h"
#include "core/geometry/transform.h"
#include "core/pipeline/stage_times.h"
#include "core/types/color.h"
#include "core/types/ids.h"
#include "core/types/image.h"

namespace hydrabench {

/// One view of one object: what a shape estimator gets (paper, "x = (I_rgb, I_depth, I_mask, K)").
/// All images have the size of the camera; `color` may be empty where a dataset has none.
struct ShapeObservation {
  std::int64_t stamp_ns = 0;
  Camera camera;
  /// As given by odometry. The world's z axis points up, so this tells the direction of gravity.
  Transform T_world_camera = Transform::Identity();
  Image<Rgb> color;
  Image<float> depth;        ///< z-depth [m]; 0: nothing measured
  Image<std::uint8_t> mask;  ///< 1 on the object, 0 elsewhere
  Label label = kUnknownLabel;
};

/// A full shape and where it is: a point v of `mesh` lies at T_camera_object * (scale * v) [m] in
/// the camera frame of the observation.
struct ShapeEstimate {
  Transform T_camera_object = Transform::Identity();
  double scale = 1;  ///< > 0
  Mesh mesh;         ///< object frame, unscaled; not empty, finite
  /// Share of the estimator's correspondences that agree with its pose, 0 to 1; 1 where the
  /// estimator has no such notion.
  double inlier_ratio = 1;
};

/// An estimate, or why there is none.
struct ShapeOutcome {
  std::optional<ShapeEstimate> estimate;
  std::string
      failure;       ///< a few words, the same for all failures of a kind; empty with an estimate
  StageTimes times;  ///< of the stages of this call
};

/// Turns a view of an object into a mesh and a pose. The pipeline does not care which one it talks
/// to. estimate() is thread-safe and a function of its arguments alone.
class ShapeEstimator {
 public:
  virtual ~ShapeEstimator() = default;
  /// @param best    the view to estimate from
  /// @param others  further views of the same object, at most maxOtherViews() of them
  /// @param seed    of whatever is drawn at random
  virtual ShapeOutcome estimate(const ShapeObservation& best,
                                std::span<const ShapeObservation> others,
                                std::uint64_t seed) const = 0;
  /// How many views besides the best one it can use.
  virtual int maxOtherViews() const { return 0; }
};

}  // namespace hydrabench

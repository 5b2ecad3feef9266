// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "core/geometry/camera.h"
#include "core/geometry/transform.h"
#include "core/types/random.h"
#include "eval/simulation/depth_noise.h"
#include "eval/simulation/street_block.h"

namespace hydrabench {

/// A camera set down somewhere, and what is wrong with its depth.
struct DrawnView {
  Camera camera;
  Transform T_world_camera = Transform::Identity();
  DepthNoiseConfig noise;
  double max_depth_m = 0;
};

/// Draws the views of a training world.
class TrainingViews {
 public:
  virtual ~TrainingViews() = default;
  /// A camera in free space that looks towards some object, not always well; nullopt where no place
  /// was found.
  virtual std::optional<DrawnView> draw(Random& random) const = 0;
};

/// @param targets  centres of the objects to look at, world frame
struct TrainingViewsConfig {
  int image_width = 360;  ///< [px]
  double max_depth_m = 5;
  std::vector<Eigen::Vector3d> targets;
};
/// A hand-held or robot's camera indoors, with the errors of the built-in one at half its
/// resolution, more or less of them.
std::unique_ptr<TrainingViews> officeViews(const Scene& scene, const TrainingViewsConfig& config);

/// A robot's camera in the street. Its depth is that of a stereo camera, which ends at 5 to 7 m, or
/// a laser's, which is exact up to max_depth_m.
std::unique_ptr<TrainingViews> streetViews(const StreetBlock& block,
                                           const TrainingViewsConfig& config);

}  // namespace hydrabench

// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "core/geometry/raycaster.h"
#include "eval/simulation/scene.h"

namespace hydrabench {

/// Points on the surface of the scene's objects, uniform by area, world frame.
struct SurfaceTargets {
  std::vector<Eigen::Vector3d> points;
  std::vector<std::size_t> object;  ///< index into Scene::objects
};
/// @param chosen  indices of the objects
SurfaceTargets surfaceTargets(const Scene& scene, std::span<const std::size_t> chosen,
                              std::size_t points_per_object);

/// seen[i] = 1 where nothing stands between the eye and a point, up to 1 cm before it.
std::vector<std::uint8_t> lineOfSight(const Raycaster& world, const Eigen::Vector3d& eye,
                                      std::span<const Eigen::Vector3d> points);

/// Share of every object's surface that some frame sees: in the image, within the range of the
/// sensor, nothing before it. Noise, drop-outs and masks play no part. Estimated from
/// points_per_object samples, so to about half of 1 / sqrt(points_per_object).
std::vector<double> visibleFractions(const Scene& scene, const Raycaster& world,
                                     const Camera& camera, std::span<const StampedPose> trajectory,
                                     double min_depth_m, double max_depth_m,
                                     std::size_t frame_stride, std::size_t points_per_object);

}  // namespace hydrabench

// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/simulation/visibility.h"

#include "core/geometry/surface_sampling.h"
#include "core/parallel/parallel_for.h"

namespace hydrabench {
namespace {

constexpr double kTolerance_m = 0.01;
constexpr std::uint64_t kTargetSeed = 20260;

}  // namespace

SurfaceTargets surfaceTargets(const Scene& scene, std::span<const std::size_t> chosen,
                              std::size_t points_per_object) {
  std::vector<std::vector<Eigen::Vector3d>> parts(chosen.size());
  parallelFor(chosen.size(), [&](std::size_t i) {
    const SceneObject& object = scene.objects[chosen[i]];
    parts[i] =
        sampleSurface(object.surface->mesh, points_per_object, hashSeed(kTargetSeed, chosen[i]))
            .points;
    for (Eigen::Vector3d& point : parts[i]) point = object.T_world_object * point;
  });
  SurfaceTargets targets;
  for (std::size_t i = 0; i < chosen.size(); ++i) {
    targets.points.insert(targets.points.end(), parts[i].begin(), parts[i].end());
    targets.object.insert(targets.object.end(), parts[i].size(), chosen[i]);
  }
  return targets;
}

std::vector<std::uint8_t> lineOfSight(const Raycaster& world, const Eigen::Vector3d& eye,
                                      std::span<const Eigen::Vector3d> points) {
  std::vector<Raycaster::Ray> rays;
  rays.reserve(points.size());
  for (const Eigen::Vector3d& point : points) {
    const Eigen::Vector3d to_point = point - eye;
    const double distance = to_point.norm();
    const double reach = distance > kTolerance_m ? 1 - kTolerance_m / distance : 0;
    rays.push_back({eye.cast<float>(), to_point.cast<float>(), 0, static_cast<float>(reach)});
  }
  std::vector<std::uint8_t> seen(points.size());
  world.occluded(rays, seen);
  for (std::uint8_t& flag : seen) flag = flag ? 0 : 1;
  return seen;
}

std::vector<double> visibleFractions(const Scene& scene, const Raycaster& world,
                                     const Camera& camera, std::span<const StampedPose> trajectory,
                                     double min_depth_m, double max_depth_m,
                                     std::size_t frame_stride, std::size_t points_per_object) {
  std::vector<double> fractions(scene.objects.size(), 0);
  parallelFor(scene.objects.size(), [&](std::size_t i) {
    const std::size_t chosen[] = {i};
    std::vector<Eigen::Vector3d> unseen = surfaceTargets(scene, chosen, points_per_object).points;
    const std::size_t total = unseen.size();
    if (total == 0) return;
    std::vector<Eigen::Vector3d> in_view;
    std::vector<Eigen::Vector3d> rest;
    for (std::size_t frame = 0; frame < trajectory.size() && !unseen.empty();
         frame += frame_stride) {
      const Transform T_camera_world = trajectory[frame].T_world_camera.inverse();
      in_view.clear();
      rest.clear();
      for (const Eigen::Vector3d& point : unseen) {
        const Eigen::Vector3d p = T_camera_world * point;
        const auto pixel = camera.project(p);
        const bool visible =
            pixel && camera.sees(*pixel) && p.z() >= min_depth_m && p.z() <= max_depth_m;
        (visible ? in_view : rest).push_back(point);
      }
      if (in_view.empty()) continue;
      const auto seen = lineOfSight(world, trajectory[frame].T_world_camera.translation(), in_view);
      for (std::size_t k = 0; k < in_view.size(); ++k) {
        if (!seen[k]) rest.push_back(in_view[k]);
      }
      unseen.swap(rest);
    }
    fractions[i] = 1 - static_cast<double>(unseen.size()) / static_cast<double>(total);
  });
  return fractions;
}

}  // namespace hydrabench

// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/oracles/true_instances.h"

#include <algorithm>
#include <numeric>

#include "core/geometry/surface_sampling.h"
#include "core/parallel/parallel_for.h"
#include "core/types/random.h"
#include "eval/simulation/visibility.h"

namespace hydrabench {
namespace {

// The scene mesh holds the objects, too: only what stands before an object's surface by more than
// this hides it.
constexpr float kTolerance_m = 0.01f;
constexpr std::size_t kRaysAtATime = 2048;
constexpr std::size_t kSurfacePoints = 400;
constexpr std::uint64_t kSurfaceSeed = 20264;

}  // namespace

std::vector<std::uint32_t> maskPixels(const Image<std::uint8_t>& mask) {
  std::vector<std::uint32_t> pixels;
  for (std::size_t i = 0; i < mask.size(); ++i) {
    if (mask.data()[i] != 0) pixels.push_back(static_cast<std::uint32_t>(i));
  }
  return pixels;
}

std::optional<std::size_t> mostFrequentObject(std::span<const std::int32_t> objects) {
  std::map<std::int32_t, std::size_t> counts;
  for (const std::int32_t object : objects) {
    if (object != TrueInstances::kNoObject) ++counts[object];
  }
  if (counts.empty()) return std::nullopt;
  const auto most =
      std::max_element(counts.begin(), counts.end(), [](const auto& a, const auto& b) {
        return a.second < b.second;  // of equals the first, which has the smallest index
      });
  return static_cast<std::size_t>(most->first);
}

TrueInstances::TrueInstances(const GroundTruth& truth) : objects_(truth.objects) {
  for (const StampedPose& pose : truth.trajectory) {
    poses_.emplace(pose.stamp_ns, pose.T_world_camera);
  }
  for (const GroundTruthObject& object : objects_) {
    const Mesh mesh = transformed(object.T_world_object, *object.mesh);
    object_surfaces_.add(mesh);
    if (truth.scene_mesh.empty()) world_.add(mesh);
  }
  object_surfaces_.commit();
  if (!truth.scene_mesh.empty()) world_.add(truth.scene_mesh);
  world_.commit();
}

Transform TrueInstances::cameraPose(std::int64_t stamp_ns, const Transform& reported) const {
  const auto found = poses_.find(stamp_ns);
  return found == poses_.end() ? reported : found->second;
}

std::vector<std::int32_t> TrueInstances::objectsAt(const Camera& camera,
                                                   const Transform& T_world_camera,
                                                   std::span<const std::uint32_t> pixels) const {
  const Eigen::Vector3f eye = T_world_camera.translation().cast<float>();
  const auto width = static_cast<std::uint32_t>(camera.width);
  std::vector<std::int32_t> seen(pixels.size(), kNoObject);
  parallelForRanges(pixels.size(), kRaysAtATime, [&](std::size_t begin, std::size_t end) {
    std::vector<Raycaster::Ray> rays;
    for (std::size_t i = begin; i < end; ++i) {
      // Of unit z-depth, so that distances are depths.
      const Eigen::Vector3d direction =
          T_world_camera.linear() * camera.backproject(pixels[i] % width, pixels[i] / width, 1);
      rays.push_back({eye, direction.cast<float>()});
    }
    std::vector<Raycaster::Hit> hits(rays.size());
    object_surfaces_.intersect(rays, hits);
    for (std::size_t i = 0; i < rays.size(); ++i) {
      rays[i].max_distance = hits[i] ? std::max(0.0f, hits[i].distance - kTolerance_m) : 0.0f;
    }
    std::vector<std::uint8_t> hidden(rays.size());
    world_.occluded(rays, hidden);
    for (std::size_t i = 0; i < rays.size(); ++i) {
      if (hits[i] && !hidden[i]) seen[begin + i] = static_cast<std::int32_t>(hits[i].mesh);
    }
  });
  return seen;
}

Image<std::int32_t> TrueInstances::render(const Camera& camera,
                                          const Transform& T_world_camera) const {
  Image<std::int32_t> image(camera.width, camera.height);
  std::vector<std::uint32_t> pixels(image.size());
  std::iota(pixels.begin(), pixels.end(), 0u);
  const std::vector<std::int32_t> seen = objectsAt(camera, T_world_camera, pixels);
  std::copy(seen.begin(), seen.end(), image.begin());
  return image;
}

std::optional<std::size_t> TrueInstances::mostSeen(const Camera& camera,
                                                   const Transform& T_world_camera,
                                                   std::span<const std::uint32_t> pixels) const {
  return mostFrequentObject(objectsAt(camera, T_world_camera, pixels));
}

double TrueInstances::visibleFraction(std::size_t object, const Camera& camera,
                                      const Transform& T_world_camera) const {
  const GroundTruthObject& truth = objects_[object];
  const SurfaceSamples samples =
      sampleSurface(*truth.mesh, kSurfacePoints, hashSeed(kSurfaceSeed, object));
  if (samples.points.empty()) return 0;
  const Transform T_camera_object = T_world_camera.inverse() * truth.T_world_object;
  std::vector<Eigen::Vector3d> in_view;
  for (const Eigen::Vector3d& point : samples.points) {
    const auto pixel = camera.project(T_camera_object * point);
    if (pixel && camera.sees(*pixel)) in_view.push_back(truth.T_world_object * point);
  }
  const std::vector<std::uint8_t> seen = lineOfSight(world_, T_world_camera.translation(), in_view);
  return static_cast<double>(std::count(seen.begin(), seen.end(), 1)) /
         static_cast<double>(samples.points.size());
}

}  // namespace hydrabench

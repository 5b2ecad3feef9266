// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "core/lidar/lidar_depth.h"

#include <algorithm>
#include <utility>

#include "core/mapping/ground/ground_scan.h"
#include "core/parallel/parallel_for.h"

namespace hydrabench {
namespace {

struct Offset {
  int u = 0;
  int v = 0;
};

/// All within a radius, the nearest first, the upper left of equals.
std::vector<Offset> offsetsWithin(int radius) {
  std::vector<Offset> offsets;
  for (int v = -radius; v <= radius; ++v) {
    for (int u = -radius; u <= radius; ++u) {
      if (u * u + v * v <= radius * radius) offsets.push_back({u, v});
    }
  }
  std::stable_sort(offsets.begin(), offsets.end(), [](const Offset& a, const Offset& b) {
    return a.u * a.u + a.v * a.v < b.u * b.u + b.v * b.v;
  });
  return offsets;
}

}  // namespace

void LidarDepth::add(std::vector<Eigen::Vector3f> points, const Transform& T_world_points) {
  scans_.push_back({std::move(points), T_world_points});
  if (scans_.size() > static_cast<std::size_t>(config_.scans)) scans_.pop_front();
}

Image<float> LidarDepth::depth(const Frame& frame) const {
  // All scans together, so that one hides what another saw past it.
  std::vector<Eigen::Vector3f> points;
  const Transform T_camera_world = frame.T_world_camera.inverse();
  for (const Scan& scan : scans_) {
    const Eigen::Affine3f T((T_camera_world * scan.T_world_points).cast<float>());
    for (const Eigen::Vector3f& p : scan.points) {
      if (isMeasured(p)) points.push_back(T * p);
    }
  }
  Image<float> depth(frame.camera.width, frame.camera.height);
  for (const CameraPoint& seen :
       visiblePoints(points, Transform::Identity(), frame.camera, config_.occlusion)) {
    float& nearest = depth.data()[seen.pixel];
    if (nearest == 0.0f || seen.depth < nearest) nearest = seen.depth;
  }
  return config_.fill_px > 0 ? filledDepth(depth, frame.instances, config_.fill_px) : depth;
}

Image<float> filledDepth(const Image<float>& depth, const Image<InstanceId>& instances,
                         int radius_px) {
  const std::vector<Offset> offsets = offsetsWithin(radius_px);
  Image<float> filled = depth;
  constexpr std::size_t kGrain = 8;
  parallelFor(
      static_cast<std::size_t>(depth.height()),
      [&](std::size_t row) {
        const int v = static_cast<int>(row);
        for (int u = 0; u < depth.width(); ++u) {
          for (const Offset& offset : offsets) {
            const int from_u = u + offset.u;
            const int from_v = v + offset.v;
            if (!depth.contains(from_u, from_v) || depth(from_u, from_v) == 0.0f) continue;
            if (!instances.empty() && instances(from_u, from_v) != instances(u, v)) continue;
            filled(u, v) = depth(from_u, from_v);
            break;
          }
        }
      },
      kGrain);
  return filled;
}

void read(ConfigReader& reader, LidarDepth::Config& config) {
  reader.field("scans", config.scans, Bounds{1, 1000});
  auto occlusion = reader.section("occlusion");
  read(occlusion, config.occlusion);
  reader.field("fill_px", config.fill_px, Bounds{0, 100});
}

}  // namespace hydrabench

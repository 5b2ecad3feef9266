// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "core/lidar/deskew.h"

#include <algorithm>
#include <array>
#include <cstddef>

#include "core/mapping/ground/ground_scan.h"
#include "core/parallel/parallel_for.h"

namespace hydrabench {

std::vector<Eigen::Vector3f> deskewed(const LidarScan& scan) {
  if (scan.times.empty()) return scan.points;
  constexpr std::size_t kSteps = 1000;
  const Transform T_end_start = scan.T_world_lidar.inverse() * scan.T_world_lidar_start;
  std::array<Eigen::Affine3f, kSteps + 1> T_end_then;
  for (std::size_t i = 0; i <= kSteps; ++i) {
    const double share = static_cast<double>(i) / kSteps;
    T_end_then[i] =
        Eigen::Affine3f(interpolate(T_end_start, Transform::Identity(), share).cast<float>());
  }
  std::vector<Eigen::Vector3f> points(scan.points.size());
  constexpr std::size_t kGrain = 4096;
  parallelFor(
      points.size(),
      [&](std::size_t i) {
        const Eigen::Vector3f& p = scan.points[i];
        const auto step = static_cast<std::size_t>(scan.times[i] * kSteps + 0.5f);
        points[i] = isMeasured(p) ? T_end_then[step] * p : p;
      },
      kGrain);
  return points;
}

std::vector<Eigen::Vector3f> levelled(const std::vector<Eigen::Vector3f>& points,
                                      const Transform& T_world_points) {
  const Eigen::Matrix3f R =
      Eigen::Quaterniond::FromTwoVectors(
          T_world_points.linear().transpose() * Eigen::Vector3d::UnitZ(), Eigen::Vector3d::UnitZ())
          .toRotationMatrix()
          .cast<float>();
  std::vector<Eigen::Vector3f> level(points.size());
  std::transform(points.begin(), points.end(), level.begin(),
                 [&](const Eigen::Vector3f& p) -> Eigen::Vector3f { return R * p; });
  return level;
}

}  // namespace hydrabench

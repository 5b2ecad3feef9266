// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "core/lidar/camera_points.h"

#include <limits>

#include <gtest/gtest.h>

namespace hydrabench {
namespace {

const Camera kCamera = {100, 80, 100, 100, 50, 40};

std::vector<std::uint32_t> seen(const std::vector<Eigen::Vector3f>& points,
                                const OcclusionConfig& config = {}) {
  std::vector<std::uint32_t> numbers;
  for (const CameraPoint& p : visiblePoints(points, Transform::Identity(), kCamera, config)) {
    numbers.push_back(p.point);
  }
  return numbers;
}

TEST(CameraPoints, KnowsPixelAndDepth) {
  Transform T_camera_points = Transform::Identity();
  T_camera_points.translation() = Eigen::Vector3d(0, 0, 1);
  const std::vector<Eigen::Vector3f> points = {{0.2f, -0.1f, 1}};
  const auto visible = visiblePoints(points, T_camera_points, kCamera, {});
  ASSERT_EQ(visible.size(), 1u);
  EXPECT_EQ(visible[0].pixel, 35u * 100 + 60);  // (50 + 100 * 0.2 / 2, 40 - 100 * 0.1 / 2)
  EXPECT_FLOAT_EQ(visible[0].depth, 2);
}

TEST(CameraPoints, LeavesOutWhatIsBehindBesideOrWithoutAReturn) {
  constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(seen({{0, 0, -2}, {2, 0, 2}, {0, 0, 0}, {kNan, 0, 2}, {0, 0, 2}}),
            std::vector<std::uint32_t>{4});
}

TEST(CameraPoints, HidesPointsBehindANearerNeighbor) {
  // 4 pixels beside each other: the second is seen by the lidar past the edge of the first.
  const std::vector<Eigen::Vector3f> points = {{0, 0, 2}, {0.16f, 0, 4}};
  EXPECT_EQ(seen(points), std::vector<std::uint32_t>{0});
  // Within 0.2 m + 5 % it is the same surface, and 30 pixels away nothing of it.
  EXPECT_EQ(seen({{0, 0, 2}, {0.09f, 0, 2.25f}}).size(), 2u);
  EXPECT_EQ(seen({{0, 0, 2}, {1.2f, 0, 4}}).size(), 2u);
  EXPECT_EQ(seen(points, {.margin_m = 2}).size(), 2u);
  EXPECT_EQ(seen(points, {.strip_px = 1}).size(), 2u);
}

TEST(CameraPoints, LooksBesideAndAboveForWhatHides) {
  // The far point 6 pixels below the near one, then 6 above it, as ground goes up to the horizon.
  EXPECT_EQ(seen({{0, 0, 2}, {0, 0.24f, 4}}), std::vector<std::uint32_t>{0});
  EXPECT_EQ(seen({{0, 0, 2}, {0, -0.24f, 4}}).size(), 2u);
  EXPECT_EQ(seen({{0, 0, 2}, {0, 0.24f, 4}}, {.above_px = 5}).size(), 2u);
}

}  // namespace
}  // namespace hydrabench

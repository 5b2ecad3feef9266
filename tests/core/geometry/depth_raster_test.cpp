// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "core/geometry/depth_raster.h"

#include <cmath>

#include <gtest/gtest.h>

#include "core/geometry/raycaster.h"

namespace hydrabench {
namespace {

using Eigen::Vector3d;

Camera camera() { return {40, 30, 20, 20, 20, 15}; }

TEST(DepthRaster, ASquareCoversThePixelsWhoseCentresItCovers) {
  // At 2 m a pixel is 0.1 m: from -0.5 to 0.5 m these are pixels 15 to 25, borders included.
  Mesh square;
  square.vertices = {{-0.5, -0.5, 2}, {0.5, -0.5, 2}, {0.5, 0.5, 2}, {-0.5, 0.5, 2}};
  square.faces = {{0, 1, 2}, {0, 2, 3}};
  const Image<float> depth = rasterizeDepth(square, camera());
  for (int v = 0; v < 30; ++v) {
    for (int u = 0; u < 40; ++u) {
      const bool inside = u >= 15 && u <= 25 && v >= 10 && v <= 20;
      ASSERT_EQ(depth(u, v), inside ? 2.0f : 0.0f) << u << " " << v;
    }
  }
}

TEST(DepthRaster, TheNearestSurfaceCountsWhicheverSideItShows) {
  Mesh mesh = boxMesh(Aabb(Vector3d(-1, -1, 3), Vector3d(1, 1, 5)));
  EXPECT_FLOAT_EQ(rasterizeDepth(mesh, camera())(20, 15), 3);
  for (Eigen::Vector3i& face : mesh.faces) std::swap(face.x(), face.y());
  EXPECT_FLOAT_EQ(rasterizeDepth(mesh, camera())(20, 15), 3);
}

TEST(DepthRaster, AFaceThatReachesBehindTheCameraIsCutNotFolded) {
  // The plane y = 1 from 3 m behind the camera to 7 m before it: row v sees it at z = 20 / (v -
  // 15), rows at or above the horizon do not, and neither do those that would see it beyond 7 m.
  Mesh floor;
  floor.vertices = {{-9, 1, -3}, {9, 1, -3}, {9, 1, 7}, {-9, 1, 7}};
  floor.faces = {{0, 1, 2}, {0, 2, 3}};
  const Image<float> depth = rasterizeDepth(floor, camera());
  for (int v = 0; v < 30; ++v) {
    const double z = v > 15 ? 20.0 / (v - 15) : 0;
    EXPECT_NEAR(depth(20, v), z > 7 ? 0 : z, 1e-6) << v;
  }
}

TEST(DepthRaster, NothingBehindTheCameraOrOutsideTheImageIsSeen) {
  for (const Vector3d& center : {Vector3d(0, 0, -3), Vector3d(30, 0, 3), Vector3d(0, -30, 3)}) {
    for (const float z : rasterizeDepth(sphereMesh(center, 1, 2), camera())) ASSERT_EQ(z, 0);
  }
}

TEST(DepthRaster, AgreesWithRaysThroughThePixels) {
  const Mesh mesh = sphereMesh({0.3, -0.2, 2.5}, 1.1, 3);
  const Image<float> depth = rasterizeDepth(mesh, camera());
  Raycaster raycaster;
  raycaster.add(mesh);
  raycaster.commit();
  int num_hit = 0;
  int num_different = 0;
  for (int v = 0; v < 30; ++v) {
    for (int u = 0; u < 40; ++u) {
      const Vector3d direction = camera().backproject(u, v, 1);
      const auto hit = raycaster.intersect({Eigen::Vector3f::Zero(), direction.cast<float>()});
      num_hit += hit ? 1 : 0;
      if (bool(hit) != (depth(u, v) > 0)) {
        ++num_different;  // Embree works in float
      } else if (hit) {
        EXPECT_NEAR(depth(u, v), hit.distance, 1e-4);
      }
    }
  }
  EXPECT_GT(num_hit, 200);
  EXPECT_LE(num_different, 1);
}

}  // namespace
}  // namespace hydrabench

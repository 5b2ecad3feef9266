// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "core/objects/rmcc.h"

#include <algorithm>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace hydrabench {
namespace {

using Eigen::Vector3d;

constexpr double kFocal = 100;

/// A camera of 200 x 160 pixels before a wall at 2 m, of which a mask is to be chosen.
ShapeObservation wallView() {
  ShapeObservation view;
  view.camera = {200, 160, kFocal, kFocal, 100, 80};
  view.depth = Image<float>(200, 160, 2.0f);
  view.mask = Image<std::uint8_t>(200, 160);
  return view;
}

void maskRectangle(int u_begin, int v_begin, int u_end, int v_end, ShapeObservation& view) {
  for (int v = v_begin; v < v_end; ++v) {
    for (int u = u_begin; u < u_end; ++u) view.mask(u, v) = 1;
  }
}

/// A square plate at z, that covers the pixels from (u_begin, v_begin) up to, not with, the ends.
Mesh plate(int u_begin, int v_begin, int u_end, int v_end, double z) {
  const Camera camera = wallView().camera;
  Mesh mesh;
  mesh.vertices = {camera.backproject(u_begin - 0.5, v_begin - 0.5, z),
                   camera.backproject(u_end - 0.5, v_begin - 0.5, z),
                   camera.backproject(u_end - 0.5, v_end - 0.5, z),
                   camera.backproject(u_begin - 0.5, v_end - 0.5, z)};
  mesh.faces = {{0, 1, 2}, {0, 2, 3}};
  return mesh;
}

RmccConfig masked(const std::string& mask) {
  RmccConfig config;
  config.mask = mask;
  return config;
}

class Rmcc : public ::testing::TestWithParam<std::string> {
 protected:
  RmccScores scores(const Mesh& mesh, const ShapeObservation& view) const {
    return rmccScores(mesh, view, masked(GetParam()));
  }
};
INSTANTIATE_TEST_SUITE_P(Masks, Rmcc, ::testing::Values("points", "raster"),
                         [](const auto& test) { return test.param; });

TEST_P(Rmcc, ASphereInsideItsDiskHasFullOverlap) {
  // A sphere of 0.4 m at 2 m shows the disk of radius 100 * 0.4 / sqrt(4 - 0.16) = 20.4 px.
  ShapeObservation view = wallView();
  int num_observed = 0;
  int num_inner = 0;
  for (int v = 0; v < 160; ++v) {
    for (int u = 0; u < 200; ++u) {
      const double radius = Vector3d(u - 100, v - 80, 0).norm();
      view.mask(u, v) = radius <= 21.5;
      num_observed += radius <= 21.5;
      num_inner += radius <= 20;
    }
  }
  const RmccScores result = scores(sphereMesh({0, 0, 2}, 0.4, 4), view);
  EXPECT_EQ(result.overlap, 1);
  EXPECT_GE(result.coverage, double(num_inner) / num_observed);
  EXPECT_LT(result.coverage, 1);
}

TEST_P(Rmcc, AShapeShiftedByHalfItsWidthOverlapsByHalf) {
  ShapeObservation view = wallView();
  maskRectangle(60, 60, 100, 100, view);
  const RmccScores result = scores(plate(80, 60, 120, 100, 2), view);
  EXPECT_DOUBLE_EQ(result.overlap, 0.5);
  EXPECT_DOUBLE_EQ(result.coverage, 0.5);
  EXPECT_NEAR(*result.depth_residual_m, 0, 1e-6);
}

TEST_P(Rmcc, OverlapIsCountedInPixelsNotInPoints) {
  // The mask has the right quarter of the shape's pixels, but more than two thirds of its surface,
  // which is folded there.
  ShapeObservation view = wallView();
  maskRectangle(110, 60, 120, 100, view);
  Mesh mesh = plate(80, 60, 120, 100, 2);
  for (int i = 0; i < 20; ++i) append(plate(112, 62, 118, 98, 2), mesh);
  EXPECT_NEAR(scores(mesh, view).overlap, 0.25, 0.02);
}

TEST_P(Rmcc, WhatLiesOutsideTheImageDoesNotCount) {
  // Only 20 of the 60 columns are in the image; the mask has all of them.
  ShapeObservation view = wallView();
  maskRectangle(0, 60, 20, 100, view);
  EXPECT_DOUBLE_EQ(scores(plate(-40, 60, 20, 100, 2), view).overlap, 1);
  EXPECT_DOUBLE_EQ(scores(plate(-40, 60, 20, 100, 2), view).coverage, 1);
}

TEST_P(Rmcc, AnEmptyProjectionScoresZero) {
  ShapeObservation view = wallView();
  maskRectangle(60, 60, 140, 100, view);
  for (const Vector3d& center : {Vector3d(0, 0, -2), Vector3d(20, 0, 2), Vector3d(0, 9, 2)}) {
    const RmccScores result = scores(sphereMesh(center, 0.4, 2), view);
    EXPECT_EQ(result.overlap, 0);
    EXPECT_EQ(result.coverage, 0);
    EXPECT_FALSE(result.depth_residual_m);
    EXPECT_STREQ(rmccRejection(result, 1, masked(GetParam())), "overlap");
  }
}

TEST_P(Rmcc, ATinyShapeInsideTheMaskFoolsThePublishedCheckOnly) {
  ShapeObservation view = wallView();
  maskRectangle(60, 60, 140, 100, view);
  const RmccScores result = scores(plate(90, 70, 98, 78, 2), view);
  EXPECT_DOUBLE_EQ(result.overlap, 1);
  EXPECT_DOUBLE_EQ(result.coverage, 64.0 / 3200);
  RmccConfig config = masked(GetParam());
  EXPECT_EQ(rmccRejection(result, 0.3, config), nullptr);
  config.check = "extended";
  EXPECT_STREQ(rmccRejection(result, 0.3, config), "coverage");
}

TEST_P(Rmcc, TheRightSilhouetteAtTheWrongDepthFoolsThePublishedCheckOnly) {
  ShapeObservation view = wallView();
  maskRectangle(60, 60, 140, 100, view);
  const RmccScores result = scores(plate(60, 60, 140, 100, 2.5), view);
  EXPECT_DOUBLE_EQ(result.overlap, 1);
  EXPECT_DOUBLE_EQ(result.coverage, 1);
  EXPECT_NEAR(*result.depth_residual_m, 0.5, 1e-6);
  RmccConfig config = masked(GetParam());
  EXPECT_EQ(rmccRejection(result, 1, config), nullptr);
  config.check = "extended";
  EXPECT_STREQ(rmccRejection(result, 1, config), "depth_residual");
  config.max_depth_residual_share = 0.51;  // of the size of the object
  EXPECT_EQ(rmccRejection(result, 1, config), nullptr);
}

TEST(RmccDepth, IsTheMedianOverMeasuredPixelsOfTheMask) {
  // Of three columns in the mask the plate is 0.1, 0.2 and 0.9 m off; a fourth measured nothing.
  ShapeObservation view = wallView();
  maskRectangle(60, 60, 64, 100, view);
  for (int v = 0; v < 160; ++v) {
    view.depth(60, v) = 2.1f;
    view.depth(61, v) = 1.8f;
    view.depth(62, v) = 2.9f;
    view.depth(63, v) = 0;
  }
  const RmccScores result = rmccScores(plate(50, 60, 80, 100, 2), view, {});
  EXPECT_NEAR(*result.depth_residual_m, 0.2, 1e-6);
  view.depth.fill(0);
  EXPECT_FALSE(rmccScores(plate(50, 60, 80, 100, 2), view, {}).depth_residual_m);
}

TEST(RmccCheck, AcceptsStrictlyAboveTheThreshold) {
  RmccConfig config;
  EXPECT_STREQ(rmccRejection({.overlap = 0.21}, 1, config), "overlap");
  EXPECT_EQ(rmccRejection({.overlap = 0.2100001}, 1, config), nullptr);
  config.check = "none";
  EXPECT_EQ(rmccRejection({.overlap = 0}, 1, config), nullptr);
  config.check = "extended";
  EXPECT_STREQ(rmccRejection({.overlap = 1, .coverage = 1}, 1, config), "depth_residual");
}

TEST(RmccMask, MorePointsFillTheGaps) {
  const Camera camera = wallView().camera;
  const Mesh mesh = plate(60, 60, 140, 100, 2);
  const auto count = [&](int points) {
    RmccConfig config;
    config.points = points;
    const Image<std::uint8_t> mask = projectedMask(mesh, camera, config);
    return std::count(mask.begin(), mask.end(), 1);
  };
  EXPECT_LT(count(1000), 1000);
  EXPECT_GT(count(20000), 3150);  // 3200 (1 - exp(-20000 / 3200)) = 3194
  const Image<std::uint8_t> raster = projectedMask(mesh, camera, masked("raster"));
  EXPECT_EQ(std::count(raster.begin(), raster.end(), 1), 3200);
}

}  // namespace
}  // namespace hydrabench

// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/simulation/visibility.h"

#include <gtest/gtest.h>

#include "eval/simulation/rgbd_renderer.h"
#include "eval/simulation/trajectory.h"
#include "tests/eval/simulation/simple_scenes.h"

namespace hydrabench {
namespace {

const Camera kCamera = {720, 480, 415.7, 415.7, 360, 240};

/// A cube of 1 m in front of the origin: its near face at x = 2.
Scene oneCube() {
  Scene scene;
  scene.objects.push_back(boxObject("chair_001", office_label::kChair, {1, 1, 1}, {2.5, 0, -0.5}));
  return scene;
}

double fractionFrom(const Scene& scene, const std::vector<StampedPose>& poses,
                    double max_depth_m = 5) {
  const RgbdRenderer renderer(std::make_shared<const Scene>(scene));
  return visibleFractions(scene, renderer.raycaster(), kCamera, poses, 0.1, max_depth_m, 1, 3000)
      .front();
}

// 3000 samples know a share to about 0.7 %.
TEST(VisibleFraction, FrontFaceOfACubeIsASixth) {
  EXPECT_NEAR(fractionFrom(oneCube(), {{0, cameraPose({0, 0}, 0, 0, 0)}}), 1.0 / 6, 0.02);
}

TEST(VisibleFraction, ViewsFromTwoSidesAddUp) {
  const std::vector<StampedPose> poses = {{0, cameraPose({0, 0}, 0, 0, 0)},
                                          {1, cameraPose({5, 0}, 0, 3.14159265358979, 0)}};
  EXPECT_NEAR(fractionFrom(oneCube(), poses), 2.0 / 6, 0.02);
}

TEST(VisibleFraction, NothingIsSeenOutOfRangeOrBehindTheCamera) {
  EXPECT_EQ(fractionFrom(oneCube(), {{0, cameraPose({0, 0}, 0, 0, 0)}}, 1.9), 0);
  EXPECT_EQ(fractionFrom(oneCube(), {{0, cameraPose({0, 0}, 0, 3.14159265358979, 0)}}), 0);
}

TEST(VisibleFraction, AWallInBetweenHidesTheRest) {
  Scene scene = oneCube();
  // Covers the half of the view with y > 0.
  scene.structure.push_back(structureBox(
      "wall", office_label::kWall, {Eigen::Vector3d(1, 0, -3), Eigen::Vector3d(1.001, 3, 3)}));
  EXPECT_NEAR(fractionFrom(scene, {{0, cameraPose({0, 0}, 0, 0, 0)}}), 1.0 / 12, 0.02);
}

}  // namespace
}  // namespace hydrabench

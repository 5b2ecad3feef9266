// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/oracles/true_instances.h"

#include <gtest/gtest.h>

#include "tests/eval/oracles/two_boxes.h"

namespace hydrabench {
namespace {

// World y = +1 is left of the image centre: columns 0 to 19 show the chair, 40 to 59 the bin.
TEST(TrueInstances, KnowsWhichObjectAPixelShows) {
  const GroundTruth truth = twoBoxes();
  const TrueInstances instances(truth);
  const std::uint32_t pixels[] = {pixelAt(10, 30), pixelAt(50, 25), pixelAt(30, 30)};
  const auto seen =
      instances.objectsAt(smallCamera(), truth.trajectory.front().T_world_camera, pixels);
  EXPECT_EQ(seen, (std::vector<std::int32_t>{0, 1, TrueInstances::kNoObject}));
}

TEST(TrueInstances, DoesNotSeeThroughStructure) {
  const GroundTruth truth = twoBoxes();
  const TrueInstances instances(truth);
  const std::uint32_t below_the_horizon[] = {pixelAt(50, 35)};
  EXPECT_EQ(instances.objectsAt(smallCamera(), truth.trajectory.front().T_world_camera,
                                below_the_horizon),
            std::vector<std::int32_t>{TrueInstances::kNoObject});

  GroundTruth without_scene = truth;
  without_scene.scene_mesh = {};
  EXPECT_EQ(
      TrueInstances(without_scene)
          .objectsAt(smallCamera(), truth.trajectory.front().T_world_camera, below_the_horizon),
      std::vector<std::int32_t>{1});
}

TEST(TrueInstances, RendersWhatItSaysOfSinglePixels) {
  const GroundTruth truth = twoBoxes();
  const TrueInstances instances(truth);
  const Image<std::int32_t> image =
      instances.render(smallCamera(), truth.trajectory.front().T_world_camera);
  const auto count = [&](int u_begin, int u_end, std::int32_t object) {
    int pixels = 0;
    for (int v = 0; v < 60; ++v) {
      for (int u = u_begin; u < u_end; ++u) pixels += image(u, v) == object;
    }
    return pixels;
  };
  // The front of the chair is 40 pixels high and ends with column 19; that of the bin begins with
  // column 40, and of its 20 rows the plate hides ten. Between them the sides are seen.
  EXPECT_EQ(count(0, 20, 0), 20 * 40);
  EXPECT_EQ(count(40, 60, 1), 20 * 10);
}

TEST(TrueInstances, TakesTheReportedPoseWhereTheTrueOneIsNotKnown) {
  const TrueInstances instances(twoBoxes());
  Transform reported = Transform::Identity();
  reported.translation().x() = 42;
  EXPECT_EQ(instances.cameraPose(8, reported).translation().x(), 42);
  EXPECT_EQ(instances.cameraPose(7, reported).translation().x(), 0);
}

TEST(TrueInstances, MeasuresHowMuchOfAnObjectAViewShows) {
  const GroundTruth truth = twoBoxes();
  const TrueInstances instances(truth);
  const Transform& pose = truth.trajectory.front().T_world_camera;
  // Of the bin's six faces the front is half hidden and of the one towards the chair the upper half
  // is seen: about (1/2 + 1/2) / 6.
  EXPECT_NEAR(instances.visibleFraction(1, smallCamera(), pose), 1.0 / 6, 0.05);
  Transform away = pose;
  away.linear() = -pose.linear();
  away.linear().col(1) = pose.linear().col(1);
  EXPECT_EQ(instances.visibleFraction(1, smallCamera(), away), 0);
}

TEST(MostFrequentObject, IsTheFirstOfEquals) {
  EXPECT_EQ(mostFrequentObject(std::vector<std::int32_t>{-1, 2, 1, -1, -1, 1, 2}), 1u);
  EXPECT_EQ(mostFrequentObject(std::vector<std::int32_t>{-1, -1}), std::nullopt);
}

}  // namespace
}  // namespace hydrabench

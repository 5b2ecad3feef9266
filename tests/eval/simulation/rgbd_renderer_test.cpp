// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/simulation/rgbd_renderer.h"

#include <gtest/gtest.h>

#include "core/geometry/raycaster.h"
#include "core/parallel/parallel_for.h"
#include "eval/simulation/trajectory.h"
#include "tests/eval/simulation/simple_scenes.h"

namespace hydrabench {
namespace {

// Not a multiple of any tile or packet.
const Camera kCamera = {101, 67, 60, 60, 50, 33};

/// A wall whose face is the plane y = 2, and a box before it.
std::shared_ptr<const Scene> wallAndBox() {
  Scene scene;
  scene.structure.push_back(structureBox(
      "wall", office_label::kWall, {Eigen::Vector3d(-10, 2, -10), Eigen::Vector3d(10, 2.2, 10)}));
  scene.objects.push_back(
      boxObject("chair_001", office_label::kChair, {0.5, 0.5, 0.5}, {0, 1.25, -0.25}));
  scene.objects.push_back(
      boxObject("bin_001", office_label::kBin, {0.2, 0.2, 0.2}, {1, 1.1, -0.1}));
  return std::make_shared<const Scene>(std::move(scene));
}

const Transform kFacingWall = cameraPose({0, 0}, 0, 1.5707963267948966, 0);

TEST(RgbdRenderer, WallStraightAheadHasOneZDepthEverywhere) {
  const RenderedView view = RgbdRenderer(wallAndBox()).render(kCamera, kFacingWall);
  for (int v = 0; v < kCamera.height; ++v) {
    for (int u = 0; u < kCamera.width; ++u) {
      if (view.labels(u, v) != office_label::kWall) continue;
      EXPECT_NEAR(view.depth(u, v), 2.0f, 2e-6f);
    }
  }
  EXPECT_EQ(view.labels(0, 0), office_label::kWall);
  EXPECT_EQ(view.objects(0, 0), -1);
}

TEST(RgbdRenderer, IntegerCoordinatesArePixelCentres) {
  // The front face lies at z-depth 1 and is 29.5 px wide around the principal point: columns 50
  // - 14.75 to 50 + 14.75. Half a pixel off, and one of the columns 35 and 65 would see it.
  Scene scene;
  scene.objects.push_back(boxObject("chair_001", office_label::kChair, {29.5 / 60, 0.5, 29.5 / 60},
                                    {0, 1.25, -29.5 / 120}));
  const RenderedView view =
      RgbdRenderer(std::make_shared<const Scene>(std::move(scene))).render(kCamera, kFacingWall);
  EXPECT_NEAR(view.depth(50, 33), 1.0f, 1e-6f);
  for (int u = 0; u < kCamera.width; ++u) {
    EXPECT_EQ(view.objects(u, 33) == 0, u >= 36 && u <= 64) << u;
  }
  for (int v = 0; v < kCamera.height; ++v) {
    EXPECT_EQ(view.objects(50, v) == 0, v >= 19 && v <= 47) << v;
  }
}

TEST(RgbdRenderer, HeadOnIncidenceIsOneAndSlantedIsTheCosine) {
  const RenderedView view = RgbdRenderer(wallAndBox()).render(kCamera, kFacingWall);
  EXPECT_EQ(view.incidence(50, 33), 255);
  // Column 0 looks 50 / 60 sideways: cos = 1 / sqrt(1 + (50/60)^2 + (33/60)^2) in the corner.
  EXPECT_NEAR(view.incidence(0, 0), 255 / std::sqrt(1 + 2500.0 / 3600 + 1089.0 / 3600), 1);
}

TEST(RgbdRenderer, EveryPixelAgreesWithARayOfItsOwn) {
  const auto scene = std::make_shared<const Scene>(twoRooms());
  const RgbdRenderer renderer(scene);
  const Transform pose = cameraPose({0.6, 0.7}, 1.1, 0.6, 0.2);
  const RenderedView view = renderer.render(kCamera, pose);
  for (int v = 0; v < kCamera.height; ++v) {
    for (int u = 0; u < kCamera.width; ++u) {
      const Eigen::Vector3d direction = pose.linear() * kCamera.backproject(u, v, 1);
      const Raycaster::Hit hit = renderer.raycaster().intersect(
          {pose.translation().cast<float>(), direction.cast<float>()});
      if (!hit) {
        EXPECT_EQ(view.depth(u, v), 0);
        EXPECT_EQ(view.labels(u, v), kUnknownLabel);
        continue;
      }
      EXPECT_NEAR(view.depth(u, v), hit.distance, 1e-5f);
      const bool is_object = hit.mesh < scene->objects.size();
      EXPECT_EQ(view.objects(u, v), is_object ? static_cast<std::int32_t>(hit.mesh) : -1);
      const Label label = is_object ? scene->objects[hit.mesh].label
                                    : scene->structure[hit.mesh - scene->objects.size()].label;
      EXPECT_EQ(view.labels(u, v), label);
    }
  }
}

TEST(RgbdRenderer, ShadowFallsBehindTheBoxAndLightBesideIt) {
  // Lamp at x = 0.5, box in the middle of the room: the floor just beyond the box is darker than
  // the same distance away beside it.
  Scene scene = twoRooms();
  scene.lamps = {{{0.5, 2, 2.4}, 4, 0}};
  const RgbdRenderer renderer(std::make_shared<const Scene>(std::move(scene)));
  const auto brightness = [&](const Eigen::Vector3d& spot) {
    const Eigen::Vector3d eye(spot.x(), spot.y() - 0.9, 2);
    const Transform pose = lookAt(eye, spot);
    const RenderedView view = renderer.render(kCamera, pose);
    return static_cast<int>(view.color(50, 33).g);
  };
  EXPECT_LT(brightness({2.6, 2, 0}), brightness({2.6, 3.2, 0}) - 12);
}

TEST(RgbdRenderer, GivesTheSameBytesForAnyNumberOfThreads) {
  const RgbdRenderer renderer(std::make_shared<const Scene>(twoRooms()));
  const Transform pose = cameraPose({0.6, 0.7}, 1.1, 0.6, 0.2);
  setNumThreads(1);
  const RenderedView one = renderer.render(kCamera, pose);
  for (const int threads : {2, 7}) {
    setNumThreads(threads);
    const RenderedView many = renderer.render(kCamera, pose);
    EXPECT_EQ(many.color, one.color);
    EXPECT_EQ(many.depth, one.depth);
    EXPECT_EQ(many.objects, one.objects);
    EXPECT_EQ(many.incidence, one.incidence);
  }
  setNumThreads(0);
}

TEST(RgbdRenderer, OverheadPartsCanBeLeftOut) {
  Scene scene = twoRooms();
  scene.structure.push_back(
      structureBox("ceiling", office_label::kCeiling,
                   {Eigen::Vector3d(-0.2, -0.2, 2.5), Eigen::Vector3d(8.4, 4.2, 2.6)}));
  scene.structure.back().overhead = true;
  const auto shared = std::make_shared<const Scene>(std::move(scene));
  const Transform from_above = lookAt({2, 1, 6}, {2, 1.001, 0});
  EXPECT_EQ(RgbdRenderer(shared).render(kCamera, from_above).labels(50, 33),
            office_label::kCeiling);
  EXPECT_EQ(
      RgbdRenderer(shared, {.with_overhead = false}).render(kCamera, from_above).labels(50, 33),
      office_label::kFloor);
}

}  // namespace
}  // namespace hydrabench

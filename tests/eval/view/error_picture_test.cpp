// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/view/error_picture.h"

#include <algorithm>

#include <gtest/gtest.h>

namespace hydrabench {
namespace {

GroundTruthObject cube(ObjectId id, const std::string& subtype, double x) {
  GroundTruthObject object;
  object.id = id;
  object.label = 5;
  object.name = "cube_" + std::to_string(id);
  object.subtype = subtype;
  object.T_world_object.translation().x() = x;
  object.mesh = std::make_shared<const Mesh>(
      boxMesh(Aabb(Eigen::Vector3d(-0.5, -0.5, 0), Eigen::Vector3d(0.5, 0.5, 1))));
  return object;
}

ObjectNode nodeOf(const GroundTruthObject& object, double shift) {
  ObjectNode node;
  node.id = object.id + 100;
  node.label = object.label;
  node.mesh = transformed(object.T_world_object, *object.mesh);
  for (Eigen::Vector3d& vertex : node.mesh.vertices) vertex.x() += shift;
  return node;
}

GroundTruth threeCubes() {
  GroundTruth truth;
  truth.objects = {cube(1, "a", 0), cube(2, "a", 3), cube(3, "b", 6)};
  return truth;
}

TEST(CompareObjects, ShowsEveryVariantBeforeASecondOfOne) {
  const GroundTruth truth = threeCubes();
  const auto objects = compareObjects(truth, {}, 2);
  ASSERT_EQ(objects.size(), 2u);
  EXPECT_EQ(objects[0].truth->id, 1u);
  EXPECT_EQ(objects[1].truth->id, 3u);
  EXPECT_EQ(compareObjects(truth, {}, 10).size(), 3u);
}

TEST(CompareObjects, FindsTheEstimateOfEachObject) {
  const GroundTruth truth = threeCubes();
  Prediction near;
  near.graph.objects = {nodeOf(truth.objects[2], 0.1), nodeOf(truth.objects[0], 0.6)};
  const std::vector<Prediction> predictions = {near, {}};
  const auto objects = compareObjects(truth, predictions, 10);
  EXPECT_EQ(objects[0].estimates, (std::vector<const Mesh*>{nullptr, nullptr}));  // 0.6 m away
  EXPECT_EQ(objects[2].estimates[0], &predictions[0].graph.objects[0].mesh);
}

TEST(ErrorPicture, ColoursEachPointByItsDistance) {
  const GroundTruth truth = threeCubes();
  Prediction exact, off;
  exact.graph.objects = {nodeOf(truth.objects[0], 0)};
  off.graph.objects = {nodeOf(truth.objects[0], 0.45)};
  const std::vector<Prediction> predictions = {exact, off};
  ErrorPictureStyle style;
  style.tile_px = 48;
  style.points = 50;
  const Image<Rgb> picture = errorPicture(compareObjects(truth, predictions, 1), {"a", "b"}, style);
  // Beyond the end of the scale there is yellow, and none of it where the estimate is exact. The
  // scale itself stands below.
  const auto yellow = [&](int u_begin, int u_end) {
    int pixels = 0;
    for (int v = 34; v < 34 + 48; ++v) {
      for (int u = u_begin; u < u_end; ++u) {
        const Rgb& p = picture(u, v);
        pixels += p.r > 150 && p.g > 150 && p.b < 90;
      }
    }
    return pixels;
  };
  const int half = 150 + 2 * 48 + 2 * 10;
  EXPECT_EQ(yellow(0, half), 0);
  EXPECT_GT(yellow(half, picture.width()), 50);
}

TEST(ScaleColor, BrightensFromEndToEnd) {
  const auto brightness = [](Rgb c) { return 0.299 * c.r + 0.587 * c.g + 0.114 * c.b; };
  double last = -1;
  for (int i = 0; i <= 20; ++i) {
    const double now = brightness(scaleColor(i / 20.0));
    EXPECT_GT(now, last);
    last = now;
  }
  EXPECT_EQ(scaleColor(7), scaleColor(1));
}

}  // namespace
}  // namespace hydrabench

// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/simulation/preview_renderer.h"

#include <gtest/gtest.h>

#include "core/parallel/parallel_for.h"
#include "eval/simulation/contact_sheet.h"
#include "eval/simulation/label_text.h"
#include "eval/simulation/smooth_normals.h"

namespace hydrabench {
namespace {

using Eigen::Vector3d;

PreviewObject redBox() {
  PreviewObject object;
  object.mesh = boxMesh(Aabb(Vector3d(-0.5, -0.5, 0), Vector3d(0.5, 0.5, 1)));
  object.color = {220, 30, 30};
  return object;
}

Image<Rgb> renderBox() {
  const PreviewObject object = redBox();
  const Camera camera = previewCamera(60, 48, 0.5);
  return renderPreview({object}, camera, previewPose(bounds(object.mesh), camera, 0.6, 0.4, 1.4));
}

TEST(RenderPreview, ShowsTheObjectOnTheBackground) {
  const Image<Rgb> image = renderBox();
  const Rgb middle = image(30, 24);
  EXPECT_GT(middle.r, 2 * middle.g);
  const Rgb corner = image(0, 0);
  EXPECT_NEAR(corner.r, PreviewStyle{}.background.r, 2);
  EXPECT_NEAR(corner.b, PreviewStyle{}.background.b, 2);
}

TEST(RenderPreview, IsTheSameForAnyNumberOfThreads) {
  const int before = numThreads();
  setNumThreads(1);
  const Image<Rgb> one = renderBox();
  setNumThreads(3);
  const Image<Rgb> three = renderBox();
  setNumThreads(before);
  EXPECT_EQ(one, three);
}

TEST(RenderPreview, DarkensTheFloorWhereTheObjectStands) {
  const PreviewObject object = redBox();
  const Camera camera = previewCamera(80, 80, 0.8);
  const Image<Rgb> image =
      renderPreview({object}, camera, lookAt(Vector3d(-1, -1.5, 6), Vector3d(0, 0, 0)));
  int darkened = 0;
  for (const Rgb& pixel : image) {
    if (pixel.r < 190 && std::abs(pixel.r - pixel.g) < 12) ++darkened;
  }
  EXPECT_GT(darkened, 50);
}

TEST(PreviewPose, KeepsEveryCornerInThePicture) {
  const Aabb box(Vector3d(-1, 2, 0), Vector3d(3, 3, 0.5));
  const Camera camera = previewCamera(200, 100, 0.6);
  const Transform pose = previewPose(box, camera, 1.0, 0.5, 1.01);
  for (int i = 0; i < 8; ++i) {
    const auto pixel =
        camera.project(pose.inverse() * box.corner(static_cast<Aabb::CornerType>(i)));
    ASSERT_TRUE(pixel);
    EXPECT_TRUE(camera.sees(*pixel)) << pixel->transpose();
  }
}

TEST(CornerNormals, StaySharpAcrossTheEdgesOfABox) {
  const Mesh box = boxMesh(Aabb(Vector3d(0, 0, 0), Vector3d(1, 1, 1)));
  for (const Eigen::Vector3f& normal : cornerNormals(box)) {
    EXPECT_FLOAT_EQ(normal.cwiseAbs().maxCoeff(), 1);
  }
}

TEST(CornerNormals, PointAwayFromTheCentreOfASphere) {
  const Mesh ball = sphereMesh(Vector3d::Zero(), 1, 3);
  const auto normals = cornerNormals(ball);
  for (std::size_t i = 0; i < normals.size(); ++i) {
    const int id = ball.faces[i / 3][static_cast<Eigen::Index>(i % 3)];
    const Eigen::Vector3f radial = ball.vertices[static_cast<std::size_t>(id)].cast<float>();
    EXPECT_GT(normals[i].dot(radial), 0.999f);
  }
}

TEST(DrawText, SetsThePixelsOfItsGlyphsAndNoOthers) {
  Image<Rgb> image(20, 12, {0, 0, 0});
  drawText(image, 1, 2, "I", {255, 255, 255});
  int set = 0;
  for (const Rgb& pixel : image) set += pixel.r == 255 ? 1 : 0;
  EXPECT_EQ(set, 7 + 2 + 2);  // stem and serifs
  EXPECT_EQ(image(3, 2), (Rgb{255, 255, 255}));
  EXPECT_EQ(textWidth("II"), 11);
  drawText(image, 15, 8, "W", {255, 255, 255}, 3);  // runs over the border without harm
}

TEST(ContactSheet, HasARowForEveryFamily) {
  const std::vector<ShapeFamily> families = {shapeFamily("bin_small"), shapeFamily("keyboard")};
  const Image<Rgb> sheet = renderContactSheet(families, 1, 2, {.cell_px = 40, .blocks = 1});
  EXPECT_GE(sheet.width(), 80);
  EXPECT_GE(sheet.height(), 80);
  EXPECT_EQ(sheet, renderContactSheet(families, 1, 2, {.cell_px = 40, .blocks = 1}));
}

}  // namespace
}  // namespace hydrabench

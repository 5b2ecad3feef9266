// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "core/shape/crisp/crisp_crop.h"

#include <cmath>
#include <limits>
#include <numeric>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace hydrabench {
namespace {

using ::testing::ElementsAre;

CrispManifest plainColors() {
  CrispManifest manifest;
  manifest.input_normalisation = "none";
  return manifest;
}

/// 8 x 6 pixels at 2 m; red grows by 51 (a fifth) per column, green by 51 per row; the mask covers
/// columns 2 to 5 of rows 1 to 2.
ShapeObservation plainView() {
  ShapeObservation view;
  view.camera = {.width = 8, .height = 6, .fx = 4, .fy = 4, .cx = 0, .cy = 0};
  view.color = Image<Rgb>(8, 6);
  view.depth = Image<float>(8, 6, 2.0f);
  view.mask = Image<std::uint8_t>(8, 6);
  for (int v = 0; v < 6; ++v) {
    for (int u = 0; u < 8; ++u) {
      const auto grade = [](int i) { return static_cast<std::uint8_t>(51 * std::min(i, 5)); };
      view.color(u, v) = {grade(u), grade(v), 255};
      view.mask(u, v) = u >= 2 && u <= 5 && v >= 1 && v <= 2;
    }
  }
  return view;
}

TEST(CrispCrop, BoxIsTightAndInclusive) {
  EXPECT_EQ(tightBox(plainView().mask), (PixelBox{2, 1, 5, 2}));
  EXPECT_EQ(tightBox(Image<std::uint8_t>(8, 6)), std::nullopt);
  EXPECT_EQ(makeCrispCrop(plainView(), plainColors(), 4)->box, (PixelBox{2, 1, 5, 2}));
}

TEST(CrispCrop, EmptyMaskGivesNone) {
  ShapeObservation view = plainView();
  view.mask.fill(0);
  EXPECT_FALSE(makeCrispCrop(view, CrispManifest()));
}

TEST(CrispCrop, StretchesToASquareWithoutAlignedCorners) {
  // Four columns stay, two rows become four: at 0 (clamped), 0.25, 0.75 and 1 (clamped).
  const CrispCrop crop = *makeCrispCrop(plainView(), plainColors(), 4);
  ASSERT_EQ(crop.color.size(), 48u);
  for (std::size_t column = 0; column < 4; ++column) {
    EXPECT_NEAR(crop.color[column], 0.2 * (2 + static_cast<double>(column)), 1e-6);
  }
  const double rows[] = {0.2, 0.25, 0.35, 0.4};
  for (std::size_t row = 0; row < 4; ++row) {
    EXPECT_NEAR(crop.color[16 + 4 * row + 3], rows[row], 1e-6);
  }
  EXPECT_FLOAT_EQ(crop.color[32], 1);  // blue
}

TEST(CrispCrop, NormalisesLikeImageNet) {
  const CrispCrop crop = *makeCrispCrop(plainView(), CrispManifest(), 4);
  EXPECT_NEAR(crop.color[0], (0.4 - 0.485) / 0.229, 1e-6);
  EXPECT_NEAR(crop.color[16], (0.2 - 0.456) / 0.224, 1e-6);
  EXPECT_NEAR(crop.color[32], (1.0 - 0.406) / 0.225, 1e-6);
}

TEST(CrispCrop, PointsAreThoseOfTheNearestPixelByTheCameraOfTheWholeImage) {
  const CrispCrop crop = *makeCrispCrop(plainView(), plainColors(), 8);
  // Column 3 of 8 shows column 1 of the box, pixel 3; row 5 shows row 1, pixel 2.
  EXPECT_TRUE(crop.points[5 * 8 + 3].isApprox(Eigen::Vector3f(3 * 2 / 4.0f, 2 * 2 / 4.0f, 2)));
  EXPECT_EQ(std::accumulate(crop.valid.begin(), crop.valid.end(), 0), 64);
  EXPECT_EQ(crop.measured_pixels, 8u);
}

TEST(CrispCrop, OutsideOfTheImageIsZeroAndNotValid) {
  const CrispCrop crop = makeCrispCrop(plainView(), PixelBox{-2, 1, 1, 2}, plainColors(), 4);
  EXPECT_EQ(crop.color[0], 0);
  EXPECT_EQ(crop.color[32], 0);
  EXPECT_EQ(crop.color[34], 1);
  EXPECT_THAT(crop.valid, ::testing::Each(0));
}

TEST(CrispCrop, PixelsWithoutUsableDepthAreNotValid) {
  ShapeObservation view = plainView();
  view.depth(2, 1) = 0;
  view.depth(3, 1) = std::numeric_limits<float>::quiet_NaN();
  view.depth(4, 1) = 500;
  view.depth(5, 1) = -1;
  const CrispCrop crop = makeCrispCrop(view, PixelBox{2, 1, 5, 1}, plainColors(), 4);
  EXPECT_THAT(crop.valid, ::testing::Each(0));
  EXPECT_EQ(makeCrispCrop(view, plainColors(), 4)->measured_pixels, 4u);
}

TEST(CrispCrop, CameraWithoutFocalLengthGivesNoPoint) {
  ShapeObservation view = plainView();
  view.camera.fx = 0;
  EXPECT_EQ(makeCrispCrop(view, plainColors(), 4)->measured_pixels, 0u);
}

TEST(NocsPairs, AreGatheredByTheMaskNotByValue) {
  ShapeObservation view = plainView();
  view.mask.fill(0);
  view.mask(2, 1) = view.mask(3, 2) = 1;
  const CrispCrop crop = *makeCrispCrop(view, plainColors(), 2);
  std::vector<float> nocs(12, 0.0f);  // 3 x 2 x 2, all zero: as good a value as any
  nocs[3] = 0.75f;
  const NocsPairs metric = gatherNocsPairs(crop, nocs, plainColors(), 1000, 1);
  ASSERT_EQ(metric.nocs.size(), 2u);
  EXPECT_EQ(metric.nocs[0], Eigen::Vector3d(0, 0, 0));
  EXPECT_EQ(metric.nocs[1], Eigen::Vector3d(0.75, 0, 0));
  EXPECT_EQ(metric.points[0], Eigen::Vector3d(1, 0.5, 2));
  EXPECT_EQ(metric.points[1], Eigen::Vector3d(1.5, 1, 2));

  CrispManifest normalised;
  normalised.mode = "normalised";
  const NocsPairs pairs = gatherNocsPairs(crop, nocs, normalised, 1000, 1);
  EXPECT_EQ(pairs.nocs[0], Eigen::Vector3d(-1, -1, -1));
  EXPECT_EQ(pairs.nocs[1], Eigen::Vector3d(0.5, -1, -1));
}

TEST(NocsPairs, AreDrawnBySeedWhereThereAreTooMany) {
  const CrispCrop crop = *makeCrispCrop(plainView(), plainColors(), 20);
  std::vector<float> nocs(1200);
  std::iota(nocs.begin(), nocs.end(), 0.0f);
  const NocsPairs a = gatherNocsPairs(crop, nocs, plainColors(), 50, 7);
  const NocsPairs b = gatherNocsPairs(crop, nocs, plainColors(), 50, 7);
  const NocsPairs c = gatherNocsPairs(crop, nocs, plainColors(), 50, 8);
  ASSERT_EQ(a.nocs.size(), 50u);
  EXPECT_EQ(a.nocs, b.nocs);
  EXPECT_NE(a.nocs, c.nocs);
  for (std::size_t i = 0; i < 50; ++i) {
    const auto pixel = static_cast<std::size_t>(a.nocs[i].x());
    EXPECT_EQ(a.points[i], crop.points[pixel].cast<double>());
  }
}

}  // namespace
}  // namespace hydrabench

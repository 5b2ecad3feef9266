// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/view/rejection_picture.h"

#include <gtest/gtest.h>

namespace hydrabench {
namespace {

/// A mask of 10 x 10 pixels around the middle of the image, and a plate that projects onto the same
/// pixels moved to the right by `shift`.
ShapeCandidate plate(int shift) {
  ShapeCandidate candidate;
  candidate.camera = {60, 60, 60, 60, 29.5, 29.5};
  candidate.mask_u = 25;
  candidate.mask_v = 25;
  candidate.mask = Image<std::uint8_t>(10, 10, 1);
  const double x = shift / 60.0;
  candidate.mesh = boxMesh(Aabb(Eigen::Vector3d(x - 5 / 60.0, -5 / 60.0, 1),
                                Eigen::Vector3d(x + 5 / 60.0, 5 / 60.0, 1.001)));
  candidate.overlap = shift == 0 ? 1 : 0;
  candidate.accepted = shift == 0;
  candidate.reason = shift == 0 ? "" : "overlap";
  return candidate;
}

RmccConfig raster() {
  RmccConfig config;
  config.mask = "raster";
  return config;
}

int count(const Image<Rgb>& image, bool (*is)(const Rgb&)) {
  return static_cast<int>(std::count_if(image.begin(), image.end(), is));
}
bool isBlue(const Rgb& p) { return p.b > p.r + 40; }
bool isOrange(const Rgb& p) { return p.r > p.b + 40; }

TEST(MaskOverlay, PaintsObservedAndProjectedPixelsApart) {
  const Image<Rgb> apart = maskOverlay(plate(12), {}, raster(), 80);
  EXPECT_GT(count(apart, isBlue), 300);
  EXPECT_GT(count(apart, isOrange), 300);
}

TEST(MaskOverlay, PaintsWhatTheyShareInNeitherColour) {
  const Image<Rgb> same = maskOverlay(plate(0), {}, raster(), 80);
  // The observed outline stays blue.
  EXPECT_EQ(count(same, isOrange), 0);
  EXPECT_LT(count(same, isBlue), count(maskOverlay(plate(12), {}, raster(), 80), isBlue));
}

TEST(RejectionPicture, ShowsWhatTheCheckTurnedDown) {
  const ColorAt no_color = [](std::int64_t) { return Image<Rgb>(); };
  ShapeCandidate failed = plate(12);
  failed.failure = "no zero crossing";
  EXPECT_TRUE(rejectionPicture({plate(0), failed}, {}, no_color, raster()).empty());
  const Image<Rgb> one = rejectionPicture({plate(12)}, {}, no_color, raster());
  const Image<Rgb> seven =
      rejectionPicture(std::vector<ShapeCandidate>(7, plate(12)), {}, no_color, raster());
  EXPECT_FALSE(one.empty());
  EXPECT_GT(seven.height(), one.height());
  EXPECT_EQ(rejectionPicture(std::vector<ShapeCandidate>(7, plate(12)), {}, no_color, raster(), 2),
            rejectionPicture(std::vector<ShapeCandidate>(2, plate(12)), {}, no_color, raster()));
}

}  // namespace
}  // namespace hydrabench

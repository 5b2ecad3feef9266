// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "core/shape/crisp/crisp_manifest.h"
#include "core/shape/shape_estimator.h"

namespace hydrabench {

/// Pixels u0..u1 x v0..v1, both ends inclusive. May reach out of the image.
struct PixelBox {
  int u0 = 0;
  int v0 = 0;
  int u1 = 0;
  int v1 = 0;
  friend bool operator==(const PixelBox&, const PixelBox&) = default;
};

/// The smallest box around the mask; nullopt where it is empty.
std::optional<PixelBox> tightBox(const Image<std::uint8_t>& mask);

/// The part of a view that CRISP's network gets, by CRISP's rule: the tight box of the mask, no
/// margin, stretched to a square whatever its aspect; the background stays. Outside of the image
/// everything is zero. One departure: CRISP loses the last row and column of the box.
struct CrispCrop {
  PixelBox box;
  int side = 0;  ///< [px]
  /// Pixels of the image in box and mask with a usable depth: a few of them stretched over the crop
  /// still are a few.
  std::size_t measured_pixels = 0;
  std::vector<float> color;             ///< 3 x side x side: bilinear, normalised, RGB planes
  std::vector<std::uint8_t> valid;      ///< side x side: in the mask with a usable depth; nearest
  std::vector<Eigen::Vector3f> points;  ///< side x side: camera frame [m]; zero where not valid
};

/// nullopt for an empty mask. Depth is usable in (0, 500) m. Needs a colour image.
std::optional<CrispCrop> makeCrispCrop(const ShapeObservation& observation,
                                       const CrispManifest& manifest, int side = 420);
CrispCrop makeCrispCrop(const ShapeObservation& observation, const PixelBox& box,
                        const CrispManifest& manifest, int side);

/// Object coordinates and camera points that belong together.
struct NocsPairs {
  std::vector<Eigen::Vector3d> nocs;    ///< metric: as put out [m]; normalised: 2 (v - 0.5)
  std::vector<Eigen::Vector3d> points;  ///< camera frame [m]
};

/// Pairs of the valid pixels, gathered by the mask and never by value. Where there are more than
/// `max_pairs`, that many are drawn with replacement (CRISP takes 1000).
/// @param nocs  3 x side x side, as the network puts it out; not checked for finite values
NocsPairs gatherNocsPairs(const CrispCrop& crop, std::span<const float> nocs,
                          const CrispManifest& manifest, std::size_t max_pairs, std::uint64_t seed);

}  // namespace hydrabench

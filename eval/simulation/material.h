// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

#include "core/types/color.h"

namespace hydrabench {

/// What a surface looks like; procedural textures are evaluated at object coordinates, so no
/// texture coordinates are needed.
struct Material {
  enum class Pattern { kPlain, kNoise, kWood, kStripes, kTiles, kLeaves, kFabric, kScreen };
  Rgb color;
  Rgb second_color;
  Pattern pattern = Pattern::kPlain;
  double pattern_size_m = 0.1;  ///< length of one repetition, or of the largest grain
  double gloss = 0;             ///< 0: matt, 1: polished
};

/// Linear-light reflectance, each channel in [0, 1], at a point of the object frame with the given
/// outward unit normal. A pure function, below 60 ns, so that a sensor can call it for every pixel.
Eigen::Vector3f evaluate(const Material& material, const Eigen::Vector3f& point,
                         const Eigen::Vector3f& normal);

/// sRGB transfer curve (IEC 61966-2-1), both ways.
Eigen::Vector3f linearFromSrgb(const Rgb& color);
Rgb srgbFromLinear(const Eigen::Vector3f& linear);

/// Smooth pseudo-random field in [0, 1] with features of size 1.
float valueNoise(const Eigen::Vector3f& point);

}  // namespace hydrabench

// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include <Eigen/Core>

#include "eval/simulation/scene.h"

namespace hydrabench {

/// A short street on an incline, full of objects: what estimators for the open air learn from. No
/// place of the campus.
struct StreetBlockConfig {
  int hydrants = 28;
  int cars = 24;
  int benches = 26;
  int unscored = 34;  ///< trees, lamp poles, bollards, signs
  InstanceSplit split = InstanceSplit::kEvaluation;
};

struct StreetBlock {
  Scene scene;
  double slope_x = 0;  ///< rise per metre along the street and across it
  double slope_y = 0;

  /// Road, pavements and lawns, under anything that stands there [m].
  double heightAt(const Eigen::Vector2d& place) const;
};

/// A function of config and seed. What finds no free place is left out. The label space is the
/// campus's.
StreetBlock makeStreetBlock(const StreetBlockConfig& config, std::uint64_t seed);

/// A part of the street that objects stand on, x along the street [m].
inline constexpr double kBlockHalfLength_m = 30;
inline constexpr double kBlockHalfWidth_m = 20;

}  // namespace hydrabench

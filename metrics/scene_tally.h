// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <span>
#include <string>

namespace hydrabench {

/// Sums over a square of the ground plan, from which the scores of a whole scene follow: sums add
/// up over squares and worlds, and squares are what intervals are drawn over.
struct SceneTally {
  /// Ground by its distance from the path: up to 5, from 5 to 10, from 10 to 20 m.
  static constexpr std::array<double, 3> kBandEnds_m = {5, 10, 20};
  static constexpr std::array<double, 3> kWithin_m = {0.05, 0.1, 0.2};  ///< of the F-scores

  std::array<double, 3> ground_m2{};          ///< true ground that was in view, per band
  std::array<double, 3> covered_ground_m2{};  ///< with the estimate within one voxel of it
  std::size_t truth_points = 0;               ///< on the true surface that was in view
  double truth_distance_m = 0;                ///< sum of their distances to the estimate
  std::array<std::size_t, 3> truth_within{};
  std::size_t estimate_points = 0;  ///< on the estimate
  double estimate_distance_m = 0;   ///< sum of their distances to the true surface
  std::array<std::size_t, 3> estimate_within{};
  std::size_t ground_points = 0;            ///< of the estimate, nearest to true ground
  double ground_square_error_m2 = 0;        ///< sum of their squared distances
  double boundary_m = 0;                    ///< edges of one face only, of the estimate's ground
  std::map<std::string, double> filled_m3;  ///< taken for solid though free, by what is nearby

  SceneTally& operator+=(const SceneTally& other);
};

SceneTally total(std::span<const SceneTally> tallies);

/// Share of the ground in view that is covered, [0, 1], higher is better; of one band, or of all
/// with band = -1. Undefined where there is none.
std::optional<double> groundCompleteness(const SceneTally& tally, int band = -1);
/// Ground in view that is not covered [m^2], lower is better.
double groundHoleArea(const SceneTally& tally);
/// Root mean square distance of the estimate's ground from the true one [m]. Undefined without any.
std::optional<double> groundRms(const SceneTally& tally);
/// Mean distance of the estimate to the true surface [m]; a part of the scene may be perfectly
/// accurate. Undefined without an estimate.
std::optional<double> sceneAccuracy(const SceneTally& tally);
/// Mean distance of the true surface in view to the estimate [m]. Undefined without either.
std::optional<double> sceneCompleteness(const SceneTally& tally);
/// F-score at kWithin_m[i]: 2 P R / (P + R) of the shares within it. Undefined without any truth.
std::optional<double> sceneFScore(const SceneTally& tally, std::size_t i);

}  // namespace hydrabench

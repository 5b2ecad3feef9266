// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "core/types/ids.h"
#include "core/types/random.h"
#include "eval/simulation/campus_loop.h"
#include "eval/simulation/floor_plan.h"

namespace hydrabench {

/// What the ground does at a place; whatever is measured about ground can be stated for each.
enum class TerrainFeature { kFlat, kSlope, kKerb, kStairs, kTerrace };
inline constexpr std::array<TerrainFeature, 5> kTerrainFeatures = {
    TerrainFeature::kFlat, TerrainFeature::kSlope, TerrainFeature::kKerb, TerrainFeature::kStairs,
    TerrainFeature::kTerrace};
std::string nameOf(TerrainFeature feature);  ///< "flat", "slope", "kerb", "stairs", "terrace"

/// Ground of the campus: the exact height of every place, continuous, in closed form.
///
/// A road with kerbs runs around a lawn, pavements on both sides of it. Level ground and smooth
/// ramps take turns. In the middle of the southern side stands a terrace held by walls, with a
/// flight of steps cut into its front. Upright faces are very steep ramps (kRamp... below), so that
/// there is one height everywhere.
class CampusTerrain {
 public:
  static constexpr double kRoadHalfWidth_m = 3.6;  ///< to the foot of the kerb
  static constexpr double kPavementWidth_m = 2.6;  ///< kerb included
  static constexpr double kEdge_m = 28;            ///< offset at which the world ends
  static constexpr double kKerbRamp_m = 0.02;      ///< horizontal run of a kerb's face
  static constexpr double kWallRamp_m = 0.04;      ///< of a wall of the terrace
  static constexpr double kRiserRamp_m = 0.01;     ///< of a step
  static constexpr double kMaxSlope = 0.10;        ///< of everything but kerbs, steps and walls

  struct Stairs {
    double x_low = 0;  ///< between its cheeks
    double x_high = 0;
    int steps = 0;
    double rise_m = 0;
    double tread_m = 0;
    double run() const { return steps * tread_m; }
  };

  /// Position and size of everything are drawn.
  explicit CampusTerrain(Random random);

  double heightAt(const Eigen::Vector2d& place) const;      ///< [m]
  double baseHeightAt(const Eigen::Vector2d& place) const;  ///< without kerbs, steps and terrace
  Eigen::Vector2d baseSlopeAt(const Eigen::Vector2d& place) const;  ///< gradient of that
  /// Slope: steeper than 3 %. Kerb, stairs, terrace: within 0.4 m of it, in this order of
  /// precedence: stairs, terrace, kerb.
  TerrainFeature featureAt(const Eigen::Vector2d& place) const;
  Label labelAt(const Eigen::Vector2d& place) const;  ///< of the campus's label space

  const CampusLoop& loop() const { return loop_; }
  const Rect& terrace() const { return terrace_; }  ///< to the foot of its walls
  const Stairs& stairs() const { return stairs_; }  ///< in the southern wall, going up to the north
  double terraceHeight() const { return stairs_.steps * stairs_.rise_m; }
  double kerbHeight() const { return kerb_m_; }
  /// Where the ground has a crease within the straights' x or y range: walls, steps, cheeks.
  /// Ascending.
  std::vector<double> creasesAlongX() const;
  std::vector<double> creasesAlongY() const;

 private:
  /// A smooth step of the ground: 3 t^2 - 2 t^3 from `from` to `from + run`.
  struct Ramp {
    double from = 0;
    double run = 1;
    double rise = 0;
    double height(double at) const;
    double slope(double at) const;
  };
  double raisedAt(const Eigen::Vector2d& place) const;  ///< by the terrace and its steps
  bool onStairs(const Eigen::Vector2d& place, double margin) const;

  CampusLoop loop_;
  std::vector<Ramp> ramps_x_;
  Ramp ramp_y_;
  Rect terrace_;
  Stairs stairs_;
  double kerb_m_ = 0.13;
};

}  // namespace hydrabench

// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/simulation/campus_terrain.h"

#include <algorithm>
#include <cmath>

#include "eval/simulation/campus_labels.h"

namespace hydrabench {
namespace {

using Eigen::Vector2d;

constexpr double kSlope = 0.03;    // steeper than this is a slope
constexpr double kNearby_m = 0.4;  // what belongs to a kerb, wall or step

/// 0 below the start of a ramp of given run, 1 beyond its end.
double rampUp(double distance, double run) { return std::clamp(distance / run, 0.0, 1.0); }

/// Distance from the outline of a rectangle, positive inside.
double depthInside(const Rect& rect, const Vector2d& place) {
  return std::min((place - rect.min()).minCoeff(), (rect.max() - place).minCoeff());
}

}  // namespace

std::string nameOf(TerrainFeature feature) {
  switch (feature) {
    case TerrainFeature::kFlat:
      return "flat";
    case TerrainFeature::kSlope:
      return "slope";
    case TerrainFeature::kKerb:
      return "kerb";
    case TerrainFeature::kStairs:
      return "stairs";
    case TerrainFeature::kTerrace:
      return "terrace";
  }
  return {};
}

double CampusTerrain::Ramp::height(double at) const {
  const double t = rampUp(at - from, run);
  return rise * t * t * (3 - 2 * t);
}

double CampusTerrain::Ramp::slope(double at) const {
  const double t = rampUp(at - from, run);
  return rise / run * 6 * t * (1 - t);
}

CampusTerrain::CampusTerrain(Random random) {
  // The steepest place of a ramp is 1.5 rise / run; along x and y together at most kMaxSlope.
  constexpr double kSteepestX = 0.095;
  constexpr double kSteepestY = 0.030;
  kerb_m_ = random.uniform(0.12, 0.15);
  stairs_.steps = 6 + static_cast<int>(random.index(3));
  stairs_.rise_m = random.uniform(0.145, 0.170);
  stairs_.tread_m = random.uniform(0.30, 0.34);
  const double west = random.uniform(-16, -10);
  const double length = random.uniform(20, 24);
  terrace_ = makeRect(west, -loop_.half_y_m + 0.4, west + length,
                      -loop_.half_y_m + random.uniform(10, 13));
  stairs_.x_low = west + random.uniform(0.5, 0.7) * length;
  stairs_.x_high = stairs_.x_low + random.uniform(2.6, 3.4);

  // One hill to the east of the terrace, a lower one to the west; the north lies higher or lower.
  const double sign = random.chance(0.5) ? 1 : -1;
  const double east_rise = random.uniform(1.0, 1.3);
  const double east_from = terrace_.max().x() + 3;
  ramps_x_.push_back({east_from, 1.5 * east_rise / kSteepestX, sign * east_rise});
  const double west_rise = random.uniform(0.6, 0.9);
  const double west_run = 1.5 * west_rise / random.uniform(0.07, kSteepestX);
  const double west_side = random.chance(0.5) ? 1 : -1;
  ramps_x_.push_back({terrace_.min().x() - 4 - west_run, west_run, west_side * west_rise});
  const double north_rise = random.uniform(0.25, 0.40);
  const double north_run = 1.5 * north_rise / kSteepestY;
  ramp_y_ = {terrace_.max().y() + 1, north_run, random.chance(0.5) ? north_rise : -north_rise};
}

double CampusTerrain::baseHeightAt(const Vector2d& place) const {
  double height = ramp_y_.height(place.y());
  for (const Ramp& ramp : ramps_x_) height += ramp.height(place.x());
  return height;
}

Vector2d CampusTerrain::baseSlopeAt(const Vector2d& place) const {
  Vector2d slope(0, ramp_y_.slope(place.y()));
  for (const Ramp& ramp : ramps_x_) slope.x() += ramp.slope(place.x());
  return slope;
}

double CampusTerrain::raisedAt(const Vector2d& place) const {
  const double x = place.x();
  const double y = place.y();
  const double sides =
      rampUp(std::min(x - terrace_.min().x(), terrace_.max().x() - x), kWallRamp_m) *
      rampUp(terrace_.max().y() - y, kWallRamp_m);
  const double front = y - terrace_.min().y();
  if (sides == 0 || front <= 0) return 0;
  const double wall = terraceHeight() * rampUp(front, kWallRamp_m);
  const double inside =
      rampUp(std::min(x - stairs_.x_low, stairs_.x_high - x) + kWallRamp_m, kWallRamp_m);
  double flight = 0;
  for (int i = 0; i < stairs_.steps; ++i) {
    flight += stairs_.rise_m * rampUp(front - i * stairs_.tread_m, kRiserRamp_m);
  }
  return sides * ((1 - inside) * wall + inside * flight);
}

double CampusTerrain::heightAt(const Vector2d& place) const {
  const double beyond_kerb = std::abs(loop_.offsetOf(place)) - kRoadHalfWidth_m;
  return baseHeightAt(place) + kerb_m_ * rampUp(beyond_kerb, kKerbRamp_m) + raisedAt(place);
}

bool CampusTerrain::onStairs(const Vector2d& place, double margin) const {
  const double front = place.y() - terrace_.min().y();
  return place.x() > stairs_.x_low - margin && place.x() < stairs_.x_high + margin &&
         front > -margin && front < stairs_.run() + margin;
}

TerrainFeature CampusTerrain::featureAt(const Vector2d& place) const {
  if (onStairs(place, kNearby_m)) return TerrainFeature::kStairs;
  // Outside of a corner of the terrace this reaches a little farther than kNearby_m.
  if (std::abs(depthInside(terrace_, place)) < kNearby_m) return TerrainFeature::kTerrace;
  const double offset = std::abs(loop_.offsetOf(place));
  if (std::abs(offset - kRoadHalfWidth_m) < kNearby_m) return TerrainFeature::kKerb;
  const bool level_top = depthInside(terrace_, place) > 0;
  return !level_top && baseSlopeAt(place).norm() > kSlope ? TerrainFeature::kSlope
                                                          : TerrainFeature::kFlat;
}

Label CampusTerrain::labelAt(const Vector2d& place) const {
  namespace id = campus_label;
  const double offset = loop_.offsetOf(place);
  if (std::abs(offset) < kRoadHalfWidth_m) return id::kRoad;
  if (std::abs(offset) < kRoadHalfWidth_m + kPavementWidth_m) return id::kSidewalk;
  if (onStairs(place, 0)) return id::kStairs;
  const double inside = depthInside(terrace_, place);
  const double front = place.y() - terrace_.min().y();
  const bool between_cheeks =
      place.x() > stairs_.x_low - kWallRamp_m && place.x() < stairs_.x_high + kWallRamp_m;
  if (inside > 0) {
    const bool cheek = between_cheeks && front < stairs_.run();
    return inside < kWallRamp_m || cheek ? id::kWall : id::kSidewalk;
  }
  // A paved way leads from the pavement to the steps.
  return between_cheeks && front < 0 && offset < 0 ? id::kSidewalk : id::kGrass;
}

std::vector<double> CampusTerrain::creasesAlongX() const {
  return {terrace_.min().x(),
          terrace_.min().x() + kWallRamp_m,
          stairs_.x_low - kWallRamp_m,
          stairs_.x_low,
          stairs_.x_high,
          stairs_.x_high + kWallRamp_m,
          terrace_.max().x() - kWallRamp_m,
          terrace_.max().x()};
}

std::vector<double> CampusTerrain::creasesAlongY() const {
  std::vector<double> creases;
  for (int i = 0; i < stairs_.steps; ++i) {
    const double riser = terrace_.min().y() + i * stairs_.tread_m;
    creases.push_back(riser);
    creases.push_back(riser + kRiserRamp_m);
    if (i == 0) creases.push_back(riser + kWallRamp_m);
  }
  creases.push_back(terrace_.min().y() + stairs_.run());
  creases.push_back(terrace_.max().y() - kWallRamp_m);
  creases.push_back(terrace_.max().y());
  return creases;
}

}  // namespace hydrabench

// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/simulation/campus_loop.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

namespace hydrabench {
namespace {

using Eigen::Vector2d;

}  // namespace

double CampusLoop::lengthAt(double offset_m) const {
  return 4 * (half_x_m + half_y_m) + 2 * std::numbers::pi * (radius_m + offset_m);
}

CampusLoop::Station CampusLoop::along(double distance_m, double offset_m) const {
  const double radius = radius_m + offset_m;
  assert(radius > 0);
  const double bend = 0.5 * std::numbers::pi * radius;
  double rest = std::fmod(distance_m, lengthAt(offset_m));
  if (rest < 0) rest += lengthAt(offset_m);
  // Sides in the order of travel: south, east, north, west, each with the bend at its end.
  Vector2d ahead = Vector2d::UnitX();
  for (int side = 0;; ++side) {
    const Vector2d out(ahead.y(), -ahead.x());
    const double half = side % 2 == 0 ? half_x_m : half_y_m;
    const double across = side % 2 == 0 ? half_y_m : half_x_m;
    const Vector2d middle = across * out;
    if (rest <= 2 * half) {
      return {middle + (rest - half) * ahead + radius * out, ahead, out, false};
    }
    rest -= 2 * half;
    if (rest <= bend || side == 3) {
      const double angle = std::min(rest / radius, 0.5 * std::numbers::pi);
      const Vector2d turned_out = std::cos(angle) * out + std::sin(angle) * ahead;
      const Vector2d turned_ahead = std::cos(angle) * ahead - std::sin(angle) * out;
      return {middle + half * ahead + radius * turned_out, turned_ahead, turned_out, true};
    }
    rest -= bend;
    ahead = -out;
  }
}

double CampusLoop::offsetOf(const Vector2d& place) const {
  const Vector2d beyond = place.cwiseAbs() - Vector2d(half_x_m, half_y_m);
  return beyond.cwiseMax(0).norm() + std::min(beyond.maxCoeff(), 0.0) - radius_m;
}

}  // namespace hydrabench

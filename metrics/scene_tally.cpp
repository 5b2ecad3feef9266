// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "metrics/scene_tally.h"

#include <cmath>
#include <numeric>

namespace hydrabench {
namespace {

template <typename Value, std::size_t kSize>
void add(std::array<Value, kSize>& to, const std::array<Value, kSize>& from) {
  for (std::size_t i = 0; i < kSize; ++i) to[i] += from[i];
}

std::optional<double> share(double part, double whole) {
  if (!(whole > 0)) return std::nullopt;
  return part / whole;
}

}  // namespace

SceneTally& SceneTally::operator+=(const SceneTally& other) {
  add(ground_m2, other.ground_m2);
  add(covered_ground_m2, other.covered_ground_m2);
  truth_points += other.truth_points;
  truth_distance_m += other.truth_distance_m;
  add(truth_within, other.truth_within);
  estimate_points += other.estimate_points;
  estimate_distance_m += other.estimate_distance_m;
  add(estimate_within, other.estimate_within);
  ground_points += other.ground_points;
  ground_square_error_m2 += other.ground_square_error_m2;
  boundary_m += other.boundary_m;
  for (const auto& [nearby, volume] : other.filled_m3) filled_m3[nearby] += volume;
  return *this;
}

SceneTally total(std::span<const SceneTally> tallies) {
  SceneTally sum;
  for (const SceneTally& tally : tallies) sum += tally;
  return sum;
}

std::optional<double> groundCompleteness(const SceneTally& tally, int band) {
  if (band >= 0) {
    const auto i = static_cast<std::size_t>(band);
    return share(tally.covered_ground_m2[i], tally.ground_m2[i]);
  }
  const auto sum = [](const auto& bands) {
    return std::accumulate(bands.begin(), bands.end(), 0.0);
  };
  return share(sum(tally.covered_ground_m2), sum(tally.ground_m2));
}

double groundHoleArea(const SceneTally& tally) {
  double area = 0;
  for (std::size_t i = 0; i < tally.ground_m2.size(); ++i) {
    area += tally.ground_m2[i] - tally.covered_ground_m2[i];
  }
  return area;
}

std::optional<double> groundRms(const SceneTally& tally) {
  const auto mean = share(tally.ground_square_error_m2, static_cast<double>(tally.ground_points));
  if (!mean) return std::nullopt;
  return std::sqrt(*mean);
}

std::optional<double> sceneAccuracy(const SceneTally& tally) {
  return share(tally.estimate_distance_m, static_cast<double>(tally.estimate_points));
}

std::optional<double> sceneCompleteness(const SceneTally& tally) {
  if (tally.estimate_points == 0) return std::nullopt;
  return share(tally.truth_distance_m, static_cast<double>(tally.truth_points));
}

std::optional<double> sceneFScore(const SceneTally& tally, std::size_t i) {
  const auto recall =
      share(static_cast<double>(tally.truth_within[i]), static_cast<double>(tally.truth_points));
  if (!recall) return std::nullopt;
  const double precision = share(static_cast<double>(tally.estimate_within[i]),
                                 static_cast<double>(tally.estimate_points))
                               .value_or(0);
  return precision + *recall > 0 ? 2 * precision * *recall / (precision + *recall) : 0;
}

}  // namespace hydrabench

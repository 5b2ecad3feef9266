// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "metrics/surface_distance.h"

#include <algorithm>

namespace hydrabench {
namespace {

double meanSquaredToSamples(const ObjectModel& from, const ObjectModel& to) {
  double sum = 0;
  for (const Eigen::Vector3d& point : from.samples()) sum += to.squaredDistanceToSamples(point);
  return sum / static_cast<double>(from.samples().size());
}

std::vector<double> distancesToSurface(const ObjectModel& from, const ObjectModel& to) {
  std::vector<double> distances(from.samples().size());
  std::transform(from.samples().begin(), from.samples().end(), distances.begin(),
                 [&](const Eigen::Vector3d& point) { return to.distanceToSurface(point); });
  return distances;
}

std::optional<double> meanOf(const std::vector<double>& distances) {
  if (distances.empty()) return std::nullopt;
  double sum = 0;
  for (const double distance : distances) sum += distance;
  return sum / static_cast<double>(distances.size());
}

std::size_t countBelow(const std::vector<double>& distances, double limit) {
  return static_cast<std::size_t>(
      std::count_if(distances.begin(), distances.end(), [&](double d) { return d < limit; }));
}

}  // namespace

std::optional<double> chamferSq(const ObjectModel& estimate, const ObjectModel& truth) {
  if (!estimate.hasSurface() || !truth.hasSurface()) return std::nullopt;
  return meanSquaredToSamples(estimate, truth) + meanSquaredToSamples(truth, estimate);
}

SurfaceDistances surfaceDistances(const ObjectModel& estimate, const ObjectModel& truth) {
  if (!estimate.hasSurface() || !truth.hasSurface()) return {};
  return {distancesToSurface(estimate, truth), distancesToSurface(truth, estimate)};
}

std::optional<double> accuracy(const SurfaceDistances& distances) {
  return meanOf(distances.estimate_to_truth);
}

std::optional<double> completeness(const SurfaceDistances& distances) {
  return meanOf(distances.truth_to_estimate);
}

std::optional<double> chamferL1(const SurfaceDistances& distances) {
  const std::optional<double> to_truth = accuracy(distances);
  const std::optional<double> to_estimate = completeness(distances);
  if (!to_truth || !to_estimate) return std::nullopt;
  return (*to_truth + *to_estimate) / 2;
}

SurfaceCounts& SurfaceCounts::operator+=(const SurfaceCounts& other) {
  estimate_samples += other.estimate_samples;
  estimate_within += other.estimate_within;
  truth_samples += other.truth_samples;
  truth_within += other.truth_within;
  return *this;
}

SurfaceCounts countWithin(const SurfaceDistances& distances, double tau_m) {
  return {distances.estimate_to_truth.size(), countBelow(distances.estimate_to_truth, tau_m),
          distances.truth_to_estimate.size(), countBelow(distances.truth_to_estimate, tau_m)};
}

std::optional<double> fScore(const SurfaceCounts& counts) {
  if (counts.estimate_samples == 0 && counts.truth_samples == 0) return std::nullopt;
  if (counts.estimate_within == 0 || counts.truth_within == 0) return 0.0;
  const double p =
      static_cast<double>(counts.estimate_within) / static_cast<double>(counts.estimate_samples);
  const double r =
      static_cast<double>(counts.truth_within) / static_cast<double>(counts.truth_samples);
  return 2 * p * r / (p + r);
}

}  // namespace hydrabench

// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "core/mapping/ground/adaptive_thresholds.h"

#include <cmath>

namespace hydrabench {
namespace {

void keepLatest(std::vector<double>& samples, int count) {
  const auto excess = static_cast<std::ptrdiff_t>(samples.size()) - count;
  if (excess > 0) samples.erase(samples.begin(), samples.begin() + excess);
}

}  // namespace

std::optional<MeanDeviation> meanDeviation(std::span<const double> values) {
  if (values.size() < 2) return std::nullopt;
  MeanDeviation result;
  for (const double value : values) result.mean += value;
  result.mean /= static_cast<double>(values.size());
  double squares = 0;
  for (const double value : values) squares += (value - result.mean) * (value - result.mean);
  result.deviation = std::sqrt(squares / static_cast<double>(values.size() - 1));
  return result;
}

AdaptiveThresholds::AdaptiveThresholds(const Config& config)
    : config_(config),
      rings_(static_cast<std::size_t>(config.rings),
             Ring{config.initial_elevation_m, config.initial_flatness_m2, {}, {}}) {}

void AdaptiveThresholds::store(std::size_t ring, double elevation_m, double flatness_m2) {
  rings_[ring].elevations.push_back(elevation_m);
  rings_[ring].flatnesses.push_back(flatness_m2);
}

void AdaptiveThresholds::adapt() {
  for (Ring& ring : rings_) {
    const bool first = &ring == &rings_.front();
    if (const auto elevation = meanDeviation(ring.elevations)) {
      const auto flatness = meanDeviation(ring.flatnesses);
      const double deviations =
          first ? config_.first_ring_deviations : config_.elevation_deviations;
      ring.max_elevation = elevation->mean + deviations * elevation->deviation;
      ring.max_flatness = flatness->mean + config_.flatness_deviations * flatness->deviation;
      // A mean above the sensor is no height of it: thresholds may have let walls through.
      if (first && config_.adapt_sensor_height && elevation->mean < 0) {
        sensor_height_ = -elevation->mean;
      }
    }
    keepLatest(ring.elevations, config_.storage);
    keepLatest(ring.flatnesses, config_.storage);
  }
}

void read(ConfigReader& reader, AdaptiveThresholds::Config& config) {
  reader.field("rings", config.rings, Bounds{0, 4000});
  reader.field("initial_elevation_m", config.initial_elevation_m, Bounds{-1000, 1000});
  reader.field("initial_flatness_m2", config.initial_flatness_m2, Bounds{0, 1000});
  reader.field("storage", config.storage, Bounds{2, 1e6});
  reader.field("first_ring_deviations", config.first_ring_deviations, Bounds{0, 100});
  reader.field("elevation_deviations", config.elevation_deviations, Bounds{0, 100});
  reader.field("flatness_deviations", config.flatness_deviations, Bounds{0, 100});
  reader.field("adapt_sensor_height", config.adapt_sensor_height);
}

}  // namespace hydrabench

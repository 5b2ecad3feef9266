// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "core/config/config_reader.h"

namespace hydrabench {

struct MeanDeviation {
  double mean = 0;
  double deviation = 0;  ///< of the sample, divided by n - 1
};
/// Empty for fewer than two values.
std::optional<MeanDeviation> meanDeviation(std::span<const double> values);

/// Patchwork++'s A-GLE: what height and what flatness a patch of ground may have in each of the
/// inner rings, learned from the patches seen there before.
class AdaptiveThresholds {
 public:
  struct Config {
    int rings = 4;                   ///< from inside; patches farther out pass by their normal
    double initial_elevation_m = 0;  ///< in the sensor frame: 0 is the height of the sensor
    double initial_flatness_m2 = 0;
    int storage = 1000;                ///< samples that are kept of each ring, the latest
    double first_ring_deviations = 3;  ///< elevation of the first ring: mean + this * deviation
    double elevation_deviations = 2;   ///< of the other rings
    double flatness_deviations = 1;
    /// The sensor's height becomes minus the mean elevation of the first ring.
    bool adapt_sensor_height = true;
  };
  explicit AdaptiveThresholds(const Config& config);

  bool covers(std::size_t ring) const { return ring < rings_.size(); }
  /// Of a ring that is covered. A patch below is not elevated [m].
  double elevation(std::size_t ring) const { return rings_[ring].max_elevation; }
  /// A patch below is flat [m^2].
  double flatness(std::size_t ring) const { return rings_[ring].max_flatness; }
  /// Learned height above the ground [m]; empty before the first ring has two samples.
  std::optional<double> sensorHeight() const { return sensor_height_; }

  /// Keeps a patch of a ring that is covered. Thresholds stay as they are until adapt().
  void store(std::size_t ring, double elevation_m, double flatness_m2);
  /// At the end of a scan. A ring with fewer than two samples keeps its thresholds. Samples above
  /// `storage` count this once more and are let go.
  void adapt();

 private:
  struct Ring {
    double max_elevation = 0;
    double max_flatness = 0;
    std::vector<double> elevations;
    std::vector<double> flatnesses;
  };
  Config config_;
  std::vector<Ring> rings_;
  std::optional<double> sensor_height_;
};

void read(ConfigReader& reader, AdaptiveThresholds::Config& config);

}  // namespace hydrabench

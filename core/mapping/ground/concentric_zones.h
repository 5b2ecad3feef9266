// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <vector>

#include "core/config/config_reader.h"

namespace hydrabench {

/// The plane around the sensor, cut into bins: four zones from inside to outside, each of rings of
/// equal width, each ring of equal sectors (Concentric Zone Model; Lim et al., Patchwork, RA-L
/// 2021). With a = min_range_m and b = max_range_m the zones begin at a, (7a + b)/8, (3a + b)/4 and
/// (a + b)/2.
class ConcentricZones {
 public:
  static constexpr int kNumZones = 4;
  struct Config {
    double min_range_m = 2.7;  ///< horizontal; nearer points are not judged
    double max_range_m = 80;
    std::vector<int> rings{2, 4, 4, 4};        ///< of each zone
    std::vector<int> sectors{16, 32, 54, 32};  ///< of each ring of a zone
  };
  static constexpr int kOutside = -1;

  /// Bins of a ring have the numbers from first_bin to first_bin + sectors - 1, counter-clockwise
  /// from the x axis.
  struct Ring {
    int zone = 0;
    int first_bin = 0;
    int sectors = 0;
  };

  explicit ConcentricZones(const Config& config);

  /// Rings of all zones, from inside to outside.
  const std::vector<Ring>& rings() const { return rings_; }
  int numBins() const { return num_bins_; }
  /// Zones follow each other: the bins below this number are those of the first.
  int binsOfFirstZone() const { return bins_of_first_zone_; }
  /// @param x, y  [m]
  /// @return      number of the bin; kOutside unless min_range_m < range <= max_range_m
  int binOf(double x, double y) const;

 private:
  struct Zone {
    double begin_m = 0;
    double ring_width_m = 0;
    int num_rings = 0;
    int first_ring = 0;
    double sectors_per_radian = 0;
  };
  double max_range_m_;
  std::array<Zone, kNumZones> zones_;
  std::vector<Ring> rings_;
  int num_bins_ = 0;
  int bins_of_first_zone_ = 0;
};

void read(ConfigReader& reader, ConcentricZones::Config& config);

}  // namespace hydrabench

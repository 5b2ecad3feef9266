// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "core/mapping/ground/concentric_zones.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

#include <fmt/format.h>

namespace hydrabench {

ConcentricZones::ConcentricZones(const Config& config) : max_range_m_(config.max_range_m) {
  const double a = config.min_range_m;
  const double b = config.max_range_m;
  const std::array<double, kNumZones + 1> begins{a, (7 * a + b) / 8, (3 * a + b) / 4, (a + b) / 2,
                                                 b};
  for (std::size_t z = 0; z < kNumZones; ++z) {
    const int num_rings = config.rings.at(z);
    const int sectors = config.sectors.at(z);
    zones_[z] = {begins[z], (begins[z + 1] - begins[z]) / num_rings, num_rings,
                 static_cast<int>(rings_.size()), sectors / (2 * std::numbers::pi)};
    for (int ring = 0; ring < num_rings; ++ring) {
      rings_.push_back({static_cast<int>(z), num_bins_, sectors});
      num_bins_ += sectors;
    }
    if (z == 0) bins_of_first_zone_ = num_bins_;
  }
}

int ConcentricZones::binOf(double x, double y) const {
  const double range = std::sqrt(x * x + y * y);
  if (!(range > zones_[0].begin_m) || range > max_range_m_) return kOutside;
  std::size_t z = kNumZones - 1;
  while (range < zones_[z].begin_m) --z;
  const Zone& zone = zones_[z];
  const int ring_of_zone =
      std::min(static_cast<int>((range - zone.begin_m) / zone.ring_width_m), zone.num_rings - 1);
  const Ring& ring = rings_[static_cast<std::size_t>(zone.first_ring + ring_of_zone)];
  double angle = std::atan2(y, x);
  if (angle < 0) angle += 2 * std::numbers::pi;
  return ring.first_bin +
         std::min(static_cast<int>(angle * zone.sectors_per_radian), ring.sectors - 1);
}

void read(ConfigReader& reader, ConcentricZones::Config& config) {
  reader.field("min_range_m", config.min_range_m, Bounds{0, 1000});
  reader.field("max_range_m", config.max_range_m, Bounds{0, 1000});
  if (!(config.max_range_m > config.min_range_m)) {
    reader.fault("max_range_m", fmt::format("{:g} is not above min_range_m ({:g})",
                                            config.max_range_m, config.min_range_m));
  }
  const auto readCounts = [&](const char* key, std::vector<int>& counts) {
    reader.field(key, counts, Bounds{1, 1000});
    if (counts.size() != std::size_t{ConcentricZones::kNumZones}) {
      reader.fault(key, fmt::format("{} numbers, expected 4, one per zone", counts.size()));
    }
  };
  readCounts("rings", config.rings);
  readCounts("sectors", config.sectors);
}

}  // namespace hydrabench

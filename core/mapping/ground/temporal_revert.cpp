// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "core/mapping/ground/temporal_revert.h"

#include <cmath>
#include <cstddef>

namespace hydrabench {

double revertProbability(const Patch& patch, const std::optional<MeanDeviation>& ring,
                         double thickness_m, const TemporalRevertConfig& config) {
  if (patch.plane.lineRatio() > config.max_line_ratio) return 0;
  const double flatness = patch.plane.flatness();
  if (patch.points.size() > static_cast<std::size_t>(config.dense_points) &&
      flatness < thickness_m * thickness_m) {
    return 1;
  }
  const double mu = ring ? ring->mean + config.flatness_deviations * ring->deviation : 0;
  return mu > 0 ? 1 / (1 + std::exp((flatness - mu) / (mu / 10))) : 0;
}

void read(ConfigReader& reader, TemporalRevertConfig& config) {
  reader.field("enabled", config.enabled);
  reader.field("flatness_deviations", config.flatness_deviations, Bounds{0, 100});
  reader.field("max_line_ratio", config.max_line_ratio, Bounds{1, 1e9});
  reader.field("dense_points", config.dense_points, Bounds{0, 1e9});
  reader.field("min_probability", config.min_probability, Bounds{0, 1});
}

}  // namespace hydrabench

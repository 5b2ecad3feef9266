// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "core/shape/scale_alignment.h"

#include <cmath>
#include <utility>
#include <vector>

#include "core/geometry/depth_raster.h"
#include "core/geometry/median.h"

namespace hydrabench {

std::optional<ScaleAlignment> measureScale(const ShapeEstimate& estimate,
                                           const ShapeObservation& observation) {
  Mesh mesh = estimate.mesh;
  for (Eigen::Vector3d& vertex : mesh.vertices) {
    vertex = estimate.T_camera_object * (estimate.scale * vertex);
  }
  const Image<float> rendered = rasterizeDepth(mesh, observation.camera);
  std::vector<double> ratios;
  for (std::size_t i = 0; i < rendered.size(); ++i) {
    const float measured = observation.depth.data()[i];
    if (observation.mask.data()[i] == 0 || !(measured > 0) || !std::isfinite(measured)) continue;
    if (rendered.data()[i] > 0) {
      ratios.push_back(static_cast<double>(measured) / static_cast<double>(rendered.data()[i]));
    }
  }
  if (ratios.empty()) return std::nullopt;
  ScaleAlignment alignment;
  alignment.pixels = static_cast<int>(ratios.size());
  alignment.factor = median(ratios);
  for (double& ratio : ratios) ratio = std::abs(ratio - alignment.factor);
  alignment.spread = median(std::move(ratios)) / alignment.factor;
  return alignment;
}

ShapeEstimate scaled(ShapeEstimate estimate, double factor) {
  estimate.scale *= factor;
  estimate.T_camera_object.translation() *= factor;
  return estimate;
}

ShapeOutcome ScaleAligned::estimate(const ShapeObservation& best,
                                    std::span<const ShapeObservation> others,
                                    std::uint64_t seed) const {
  ShapeOutcome outcome = estimator_->estimate(best, others, seed);
  if (!outcome.estimate) return outcome;
  std::optional<ScaleAlignment> alignment;
  {
    const StageTimes::Scope stage(outcome.times, "align_scale");
    alignment = measureScale(*outcome.estimate, best);
  }
  if (!alignment || alignment->pixels < config_.min_pixels) {
    outcome.failure = "too few depths to scale by";
  } else if (alignment->spread > config_.max_spread) {
    outcome.failure = "depths disagree about the scale";
  }
  if (!outcome.failure.empty()) {
    outcome.estimate.reset();
  } else {
    outcome.estimate = scaled(*std::move(outcome.estimate), alignment->factor);
  }
  return outcome;
}

void read(ConfigReader& reader, ScaleAlignmentConfig& config) {
  reader.field("enabled", config.enabled);
  reader.field("min_pixels", config.min_pixels, Bounds{1, 1e9});
  reader.field("max_spread", config.max_spread, Bounds{0, 10});
}

}  // namespace hydrabench

// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <utility>

#include "core/config/config_reader.h"
#include "core/shape/shape_estimator.h"

namespace hydrabench {

struct ScaleAlignmentConfig {
  bool enabled = false;
  int min_pixels = 100;     ///< with fewer there is no estimate
  double max_spread = 0.3;  ///< largest ScaleAlignment::spread
};
void read(ConfigReader& reader, ScaleAlignmentConfig& config);

/// What measured depth says of the scale of an estimate.
struct ScaleAlignment {
  double factor = 1;  ///< median of measured over rendered z-depth; the estimate times this fits
  int pixels = 0;     ///< of the mask, measured, on the rendered mesh
  double spread = 0;  ///< median absolute deviation of the ratios over their median
};

/// Renders the mesh where the estimate has it and compares z-depth with z-depth over the mask
/// (paper, "s = median of I_depth / rendered depth"). nullopt where no pixel has both.
std::optional<ScaleAlignment> measureScale(const ShapeEstimate& estimate,
                                           const ShapeObservation& observation);

/// The estimate, larger by the factor about the centre of the camera: mesh and place, so that it
/// covers the same pixels.
ShapeEstimate scaled(ShapeEstimate estimate, double factor);

/// An estimator whose meshes have no metric scale of their own (SAM3D), or may profit from another:
/// every estimate is scaled to the measured depth, and is none where too few pixels say how, or
/// they disagree. Stage: align_scale.
class ScaleAligned : public ShapeEstimator {
 public:
  ScaleAligned(std::shared_ptr<const ShapeEstimator> estimator, const ScaleAlignmentConfig& config)
      : estimator_(std::move(estimator)), config_(config) {}

  ShapeOutcome estimate(const ShapeObservation& best, std::span<const ShapeObservation> others,
                        std::uint64_t seed) const override;
  int maxOtherViews() const override { return estimator_->maxOtherViews(); }

 private:
  std::shared_ptr<const ShapeEstimator> estimator_;
  ScaleAlignmentConfig config_;
};

}  // namespace hydrabench

// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include "core/shape/shape_estimator.h"
#include "eval/oracles/true_instances.h"

namespace hydrabench {

/// Shows an estimator the view in which most of the object's surface is seen, instead of the one
/// with the largest box: an upper bound of choosing views. Among the views that the pipeline keeps,
/// at most 16 of a track. The consistency check stays with the pipeline's own best view.
class ViewOracle : public ShapeEstimator {
 public:
  ViewOracle(std::shared_ptr<const ShapeEstimator> estimator,
             std::shared_ptr<const TrueInstances> truth);

  ShapeOutcome estimate(const ShapeObservation& best, std::span<const ShapeObservation> others,
                        std::uint64_t seed) const override;
  int maxOtherViews() const override;

 private:
  std::shared_ptr<const ShapeEstimator> estimator_;
  std::shared_ptr<const TrueInstances> truth_;
};

}  // namespace hydrabench

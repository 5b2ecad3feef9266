// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/oracles/view_oracle.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace hydrabench {
namespace {

constexpr int kOtherViews = 15;

}  // namespace

ViewOracle::ViewOracle(std::shared_ptr<const ShapeEstimator> estimator,
                       std::shared_ptr<const TrueInstances> truth)
    : estimator_(std::move(estimator)), truth_(std::move(truth)) {}

int ViewOracle::maxOtherViews() const { return std::max(kOtherViews, estimator_->maxOtherViews()); }

ShapeOutcome ViewOracle::estimate(const ShapeObservation& best,
                                  std::span<const ShapeObservation> others,
                                  std::uint64_t seed) const {
  std::vector<const ShapeObservation*> views = {&best};
  for (const ShapeObservation& other : others) views.push_back(&other);
  const auto pose = [&](const ShapeObservation& view) {
    return truth_->cameraPose(view.stamp_ns, view.T_world_camera);
  };
  std::size_t chosen = 0;
  if (const auto object = truth_->mostSeen(best.camera, pose(best), maskPixels(best.mask))) {
    double most = -1;
    for (std::size_t i = 0; i < views.size(); ++i) {
      const ShapeObservation& view = *views[i];
      // A track may have slipped onto a neighbour.
      if (truth_->mostSeen(view.camera, pose(view), maskPixels(view.mask)) != object) continue;
      const double fraction = truth_->visibleFraction(*object, view.camera, pose(view));
      if (fraction <= most) continue;
      most = fraction;
      chosen = i;
    }
  }
  std::vector<ShapeObservation> rest;
  const auto room = static_cast<std::size_t>(estimator_->maxOtherViews());
  for (std::size_t i = 0; i < views.size() && rest.size() < room; ++i) {
    if (i != chosen) rest.push_back(*views[i]);
  }
  ShapeOutcome outcome = estimator_->estimate(*views[chosen], rest, seed);
  if (outcome.estimate) {
    // Asked for in the frame of the best view; odometry is all that the pipeline has between them.
    Transform& T_camera_object = outcome.estimate->T_camera_object;
    T_camera_object =
        best.T_world_camera.inverse() * views[chosen]->T_world_camera * T_camera_object;
  }
  return outcome;
}

}  // namespace hydrabench

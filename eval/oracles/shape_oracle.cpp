// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/oracles/shape_oracle.h"

#include <utility>

namespace hydrabench {

ShapeOracle::ShapeOracle(std::shared_ptr<const TrueInstances> truth) : truth_(std::move(truth)) {
  for (const GroundTruthObject& object : truth_->objects()) {
    Shape& shape = shapes_.emplace_back();
    shape.mesh = *object.mesh;
    const Aabb box = bounds(shape.mesh);
    if (box.isEmpty() || !(box.sizes().maxCoeff() > 0)) continue;  // never hit by a ray
    shape.center = box.center();
    shape.scale = 0.5 * box.sizes().maxCoeff();
    for (Eigen::Vector3d& vertex : shape.mesh.vertices) {
      vertex = (vertex - shape.center) / shape.scale;
    }
  }
}

ShapeOutcome ShapeOracle::estimate(const ShapeObservation& best, std::span<const ShapeObservation>,
                                   std::uint64_t) const {
  ShapeOutcome outcome;
  const StageTimes::Scope stage(outcome.times, "oracle");
  const Transform T_world_camera = truth_->cameraPose(best.stamp_ns, best.T_world_camera);
  const auto object = truth_->mostSeen(best.camera, T_world_camera, maskPixels(best.mask));
  if (!object) {
    outcome.failure = kNoObject;
    return outcome;
  }
  const Shape& shape = shapes_[*object];
  ShapeEstimate estimate;
  estimate.T_camera_object = T_world_camera.inverse() * truth_->objects()[*object].T_world_object *
                             Eigen::Translation3d(shape.center);
  estimate.scale = shape.scale;
  estimate.mesh = shape.mesh;
  outcome.estimate = std::move(estimate);
  return outcome;
}

}  // namespace hydrabench

// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "core/pipeline/shape_estimation.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "core/types/random.h"

namespace hydrabench {
namespace {

bool isUsable(const ShapeEstimate& estimate) {
  return !estimate.mesh.empty() && std::isfinite(estimate.scale) && estimate.scale > 0 &&
         estimate.T_camera_object.matrix().allFinite() &&
         std::all_of(estimate.mesh.vertices.begin(), estimate.mesh.vertices.end(),
                     [](const Eigen::Vector3d& vertex) { return vertex.allFinite(); });
}

/// The part of the mask around the object.
void cutOutMask(const Image<std::uint8_t>& mask, ShapeCandidate& candidate) {
  ImageRegion region{mask.width(), mask.height(), 0, 0};
  for (int v = 0; v < mask.height(); ++v) {
    for (int u = 0; u < mask.width(); ++u) {
      if (mask(u, v) == 0) continue;
      region = {std::min(region.u_begin, u), std::min(region.v_begin, v),
                std::max(region.u_end, u + 1), std::max(region.v_end, v + 1)};
    }
  }
  if (region.u_end == 0) return;
  candidate.mask_u = region.u_begin;
  candidate.mask_v = region.v_begin;
  candidate.mask =
      Image<std::uint8_t>(region.u_end - region.u_begin, region.v_end - region.v_begin);
  for (int v = region.v_begin; v < region.v_end; ++v) {
    for (int u = region.u_begin; u < region.u_end; ++u) {
      candidate.mask(u - region.u_begin, v - region.v_begin) = mask(u, v);
    }
  }
}

ShapeCandidate withoutEstimate(const EndedTrack& ended, const ShapeObservation& best) {
  ShapeCandidate candidate;
  candidate.track = ended.track.id;
  candidate.label = ended.track.label;
  candidate.first_observed_ns = ended.track.firstSeenNs();
  candidate.last_observed_ns = ended.track.lastSeenNs();
  candidate.observations = ended.track.observations.size();
  candidate.view_stamp_ns = best.stamp_ns;
  candidate.camera = best.camera;
  candidate.T_world_camera = best.T_world_camera;
  candidate.view_volume_m3 = ended.views.front().volume_m3;
  cutOutMask(best.mask, candidate);
  return candidate;
}

}  // namespace

ShapeCandidate estimateShape(const EndedTrack& ended, const ShapeEstimator& estimator,
                             const RmccConfig& rmcc, StageTimes& times) {
  assert(!ended.views.empty());
  const Label label = ended.track.label;
  const ShapeObservation best = shapeObservation(ended.views.front(), label);
  const std::size_t num_others = std::min(
      ended.views.size() - 1, static_cast<std::size_t>(std::max(0, estimator.maxOtherViews())));
  std::vector<ShapeObservation> others;
  for (std::size_t i = 0; i < num_others; ++i) {
    others.push_back(shapeObservation(ended.views[i + 1], label));
  }
  ShapeCandidate candidate = withoutEstimate(ended, best);

  ShapeOutcome outcome;
  {
    const StageTimes::Scope stage(times, "estimate");
    outcome = estimator.estimate(best, others, mixBits(ended.track.id));
  }
  for (const StageTimes::Stage& stage : outcome.times.stages()) {
    for (const StageTimes::Sample& sample : stage.samples) {
      times.add("estimate." + stage.name, sample);
    }
  }
  if (!outcome.estimate || !isUsable(*outcome.estimate)) {
    candidate.failure = outcome.estimate          ? "unusable estimate"
                        : outcome.failure.empty() ? "no estimate"
                                                  : outcome.failure;
    return candidate;
  }

  const StageTimes::Scope stage(times, "rmcc");
  const ShapeEstimate& estimate = *outcome.estimate;
  candidate.T_world_object = best.T_world_camera * estimate.T_camera_object;
  candidate.scale = estimate.scale;
  candidate.inlier_ratio = estimate.inlier_ratio;
  candidate.mesh = transformed(candidate.T_world_object, scaled(estimate.scale, estimate.mesh));
  roundToFloat(candidate.mesh);
  candidate.box = bounds(candidate.mesh);
  // Of the mesh as it is kept, so that scores can be made again from the record.
  const Mesh mesh_camera = transformed(best.T_world_camera.inverse(), candidate.mesh);
  const RmccScores scores = rmccScores(mesh_camera, best, rmcc);
  candidate.overlap = scores.overlap;
  candidate.coverage = scores.coverage;
  candidate.depth_residual_m = scores.depth_residual_m;
  return candidate;
}

}  // namespace hydrabench

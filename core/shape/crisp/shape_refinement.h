// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "core/config/config_reader.h"
#include "core/geometry/similarity_alignment.h"
#include "core/shape/shape_estimator.h"

namespace at {
class Tensor;
}

namespace hydrabench {

/// Test-time refinement of an estimate, beyond the paper: a bounded number of gradient steps on
/// pose, scale and latent code, so that measured points lie on the surface and the way from the
/// camera to them, and past the object, is free. Stays near the estimate it began with.
struct ShapeRefinementConfig {
  bool enabled = false;
  int steps = 60;
  int surface_points = 256;    ///< per step, of all views
  int free_points = 384;       ///< per step, of all views
  int max_other_views = 0;     ///< 0: the best view alone
  double pose_rate = 0.008;    ///< of Adam; object units and radians
  double code_rate = 0.04;     ///< in units of the spread of codes
  double max_residual = 0.15;  ///< object units; farther points say no more than that
  double free_weight = 1.0;
  double free_margin = 0.02;  ///< object units: free points are at least so far outside
  double code_weight = 0.02;  ///< pull towards the code that was predicted
  double pose_weight = 0.2;   ///< pull towards the pose that was found
  double max_shift = 0.3;     ///< object units, log scale and radians: what is not crossed
};
void read(ConfigReader& reader, ShapeRefinementConfig& config);

/// Distances [1, N] at points [1, N, 3] for a code [1, C], differentiable in both.
using LatentField = std::function<at::Tensor(const at::Tensor& points, const at::Tensor& code)>;

struct RefinedShape {
  Similarity camera_from_object;
  std::vector<float> code;
};

/// @param code_spread  standard deviation of codes, the unit of code_rate
/// @return what it began with where the fit did not get better or something is not finite.
/// Deterministic for a seed.
RefinedShape refineShape(const LatentField& field, const RefinedShape& start, double code_spread,
                         const ShapeObservation& best, std::span<const ShapeObservation> others,
                         const ShapeRefinementConfig& config, std::uint64_t seed);

}  // namespace hydrabench

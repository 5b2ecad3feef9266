// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "metrics/object_model.h"

namespace hydrabench {

/// Mean over the estimate's samples of the squared distance to the nearest sample of the truth,
/// plus the reverse (the paper's Chamfer distance, from its commented formula; the default of
/// PyTorch3D). [m^2], [0, inf), lower is better. Sample to sample, so it never reaches 0: compare
/// with ObjectModel::samplingFloor(). Either without a surface: undefined.
std::optional<double> chamferSq(const ObjectModel& estimate, const ObjectModel& truth);

/// Distances of each side's samples to the other side's triangles [m]: point to surface, so there
/// is no sampling floor and a surface against itself gives exact zeros. Everything below derives
/// from these. All samples count, however far away.
struct SurfaceDistances {
  std::vector<double> estimate_to_truth;
  std::vector<double> truth_to_estimate;
};
/// Either without a surface: both lists of the pair are empty.
SurfaceDistances surfaceDistances(const ObjectModel& estimate, const ObjectModel& truth);

/// Mean of estimate_to_truth [m], lower is better. A partial scan may be perfectly accurate.
/// Undefined when empty.
std::optional<double> accuracy(const SurfaceDistances& distances);
/// Mean of truth_to_estimate [m], lower is better. Undefined when empty.
std::optional<double> completeness(const SurfaceDistances& distances);
/// (accuracy + completeness) / 2 [m] (Mescheder et al., Occupancy Networks, CVPR 2019), lower is
/// better. Undefined when empty.
std::optional<double> chamferL1(const SurfaceDistances& distances);

/// Samples strictly within a distance of the other surface. Counts add up over objects.
struct SurfaceCounts {
  std::size_t estimate_samples = 0;
  std::size_t estimate_within = 0;
  std::size_t truth_samples = 0;
  std::size_t truth_within = 0;

  SurfaceCounts& operator+=(const SurfaceCounts& other);
};
SurfaceCounts countWithin(const SurfaceDistances& distances, double tau_m);

/// F-score at distance tau (Knapitsch et al., Tanks and Temples, ACM TOG 2017): 2 P R / (P + R),
/// where P is the share of the estimate's samples within tau of the truth and R the reverse. No
/// unit, [0, 1], higher is better. P = R = 0: 0. One side without samples: 0. Both: undefined.
std::optional<double> fScore(const SurfaceCounts& counts);

}  // namespace hydrabench

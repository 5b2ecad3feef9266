// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "core/geometry/transform.h"

namespace hydrabench {

/// p_target = scale * R * p_source + t.
struct Similarity {
  double scale = 1;
  Transform T_target_source = Transform::Identity();
  Eigen::Vector3d operator()(const Eigen::Vector3d& p) const {
    return T_target_source.linear() * (scale * p) + T_target_source.translation();
  }
};

/// Least-squares similarity (Umeyama, PAMI 1991); scale fixed to 1 on request. Needs at least 3
/// points that are not on one line: nullopt otherwise, or when a value is not finite.
std::optional<Similarity> alignSimilarity(std::span<const Eigen::Vector3d> source,
                                          std::span<const Eigen::Vector3d> target,
                                          bool with_scale = true);

/// As alignSimilarity, but among the similarities that turn the source's z axis to `up`, in closed
/// form: yaw, scale and translation. Needs 2 points that are not above each other.
/// @param up  unit vector in the frame of the target
std::optional<Similarity> alignUpright(std::span<const Eigen::Vector3d> source,
                                       std::span<const Eigen::Vector3d> target,
                                       const Eigen::Vector3d& up);

struct RobustAlignment {
  Similarity similarity;
  std::vector<std::size_t> inliers;  ///< ascending
};

/// RANSAC over 3-point samples, then refits on the inliers until they no longer change.
/// Deterministic for a seed.
/// @param max_error  residual of an inlier [unit of target]
std::optional<RobustAlignment> alignSimilarityRobust(std::span<const Eigen::Vector3d> source,
                                                     std::span<const Eigen::Vector3d> target,
                                                     double max_error, int iterations,
                                                     std::uint64_t seed, bool with_scale = true);

}  // namespace hydrabench

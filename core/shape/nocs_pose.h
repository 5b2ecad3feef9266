// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include <Eigen/Core>

#include "core/config/config_reader.h"
#include "core/geometry/similarity_alignment.h"

namespace hydrabench {

/// Pose of an object from normalised object coordinates (NOCS) of its points: RANSAC over few
/// correspondences, then Umeyama on the inliers (CRISP, Shi et al. 2025; Wang et al., CVPR 2019).
struct NocsPoseConfig {
  int min_points = 5;   ///< fewer correspondences give no pose
  int sample_size = 5;  ///< of a hypothesis
  int max_iterations = 100;
  double confidence = 0.99;  ///< of having drawn one sample without outliers
  /// Residual of an inlier, share of the diameter of the object as it is placed. CRISP has 0.1; the
  /// refits tighten it to final_threshold.
  double threshold = 0.1;
  double final_threshold = 0.05;
  int refits = 5;
  double min_inlier_ratio = 0.2;  ///< below there is no pose
};
void read(ConfigReader& reader, NocsPoseConfig& config);

/// Which motions are allowed.
enum class NocsFreedom {
  kSimilarity,  ///< rotation, translation, scale (Umeyama)
  kRigid,       ///< scale is 1: object coordinates are metric (Arun)
  kUpright,     ///< as kSimilarity, with the object's z axis along a known direction
};

struct NocsPose {
  Similarity similarity;    ///< point = scale * R * nocs + t
  double inlier_ratio = 0;  ///< of all correspondences, at final_threshold
};

/// Deterministic for a seed. nullopt where there are too few points, where they do not fix a pose
/// or too few agree, or where a value is not finite.
/// @param nocs    object coordinates, one per point
/// @param points  [m]
/// @param up      unit vector in the frame of `points` that the object's z axis points along; used
///                with kUpright only
std::optional<NocsPose> solveNocsPose(std::span<const Eigen::Vector3d> nocs,
                                      std::span<const Eigen::Vector3d> points, NocsFreedom freedom,
                                      const Eigen::Vector3d& up, const NocsPoseConfig& config,
                                      std::uint64_t seed);

}  // namespace hydrabench

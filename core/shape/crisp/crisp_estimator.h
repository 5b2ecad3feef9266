// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>

#include "core/config/config_reader.h"
#include "core/shape/crisp/shape_refinement.h"
#include "core/shape/nocs_pose.h"
#include "core/shape/sdf_mesher.h"
#include "core/shape/shape_estimator.h"

namespace hydrabench {

class CrispModel;

/// Shape and pose from one view in one forward pass, refined afterwards on request (CRISP, Shi et
/// al., CVPR 2025): the network gives object coordinates of the visible points and a distance
/// field; the first fix the pose (RANSAC), the zero set of the second is the mesh (marching cubes).
///
/// Bad views and bad predictions are failures with one of the phrases in crisp_estimator.cpp, never
/// an exception. Results do not depend on the number of threads.
class CrispEstimator : public ShapeEstimator {
 public:
  struct Config {
    std::filesystem::path model;  ///< manifest of the weights, or the folder with a manifest.yaml
    std::string device = "cpu";   ///< cpu | cuda
    NocsPoseConfig pose;
    ShapeRefinementConfig refinement;
    SdfMesherConfig mesh;  ///< its half_side is the model's
    /// Longest side of the box around the placed object [m]; an estimate outside of these is none.
    double min_size_m = 0.02;
    double max_size_m = 20;
  };

  /// Throws InputError for what is wrong with manifest, weights or device.
  explicit CrispEstimator(const Config& config);
  CrispEstimator(std::shared_ptr<const CrispModel> model, const Config& config);

  ShapeOutcome estimate(const ShapeObservation& best, std::span<const ShapeObservation> others,
                        std::uint64_t seed) const override;
  int maxOtherViews() const override;

 private:
  Config config_;
  std::shared_ptr<const CrispModel> model_;
};

void read(ConfigReader& reader, CrispEstimator::Config& config);

}  // namespace hydrabench

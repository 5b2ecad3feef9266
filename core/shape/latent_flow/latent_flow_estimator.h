// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>

#include "core/config/config_reader.h"
#include "core/shape/sdf_mesher.h"
#include "core/shape/shape_estimator.h"

namespace hydrabench {

class LatentFlowModel;

/// Shape and pose of an object drawn from a generative model (`latent flow (built in)`): a small
/// estimator of the kind of SAM3D, which it is not and is never called. Two flows (flow_sampler.h),
/// one after the other:
///
/// 1. Pose and scale tokens (pose_tokens.h), given the measured points of the view. The frame they
///    stand for is upright: gravity is known.
/// 2. Latent voxels of the shape (latent_grid.h), given what was measured in and around each of
///    them in that frame (view_grid.h), with classifier-free guidance; a decoder makes a distance
///    field of them (shape_autoencoder.h).
///
/// The second is trained in frames that are a little off and draws the shape where the points are,
/// not where the frame says: no registration comes after it. The mesh is scale-free, its metric
/// scale that of the frame, which was found in metres; `align_scale` may correct it afterwards
/// (scale_alignment.h). Colour is not used: in the offices it adds nothing to depth.
///
/// Bad views and bad predictions are failures, never an exception. The same seed gives the same
/// mesh, for any number of threads.
class LatentFlowEstimator : public ShapeEstimator {
 public:
  struct Config {
    std::filesystem::path model;  ///< manifest of the weights, or the folder with a manifest.yaml
    std::string device = "cpu";   ///< cpu | cuda
    int steps = 25;               ///< of either flow; 4 is cheap
    int pose_samples = 16;        ///< frames drawn, of which the middle one is taken
    double guidance = 1.5;        ///< weight of the view; 1: as it is, at half the cost
    SdfMesherConfig mesh;         ///< its half_side is the model's
    /// Longest side of the box around the placed object [m]; an estimate outside of these is none.
    double min_size_m = 0.02;
    double max_size_m = 20;
  };

  /// Throws InputError for what is wrong with manifest, weights or device.
  explicit LatentFlowEstimator(const Config& config);
  LatentFlowEstimator(std::shared_ptr<const LatentFlowModel> model, const Config& config);

  /// Stages: view, pose_flow, shape_flow, mesh.
  ShapeOutcome estimate(const ShapeObservation& best, std::span<const ShapeObservation> others,
                        std::uint64_t seed) const override;

 private:
  Config config_;
  std::shared_ptr<const LatentFlowModel> model_;
};

void read(ConfigReader& reader, LatentFlowEstimator::Config& config);

}  // namespace hydrabench

// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
//
// Includes libtorch: for the sources of the trainers only.
#pragma once

#include <vector>

#include "core/shape/latent_flow/latent_flow_network.h"
#include "eval/training/flow_phase.h"
#include "eval/training/flow_pool.h"

namespace hydrabench {

/// Reconstruction of distances from grids (column sdf_l1), with noise on the latents.
PhaseLoss autoencoderLoss(const LatentFlowTrainingConfig::Autoencoder& config,
                          ShapeAutoencoder& network, const std::vector<FieldSample>& samples,
                          Random random);

/// Grids as the encoder takes them: [B, kGridSide^3].
torch::Tensor makeGrids(const std::vector<const ShapeGrid*>& grids);

/// x_t and the velocity to learn, for data [B, ...]: times are drawn around the middle
/// (logit-normal, as in Esser et al., ICML 2024), noise is normal.
struct FlowTarget {
  torch::Tensor x;
  torch::Tensor time;      ///< [B]
  torch::Tensor velocity;  ///< of x's shape
};
FlowTarget drawFlowTarget(const torch::Tensor& data, Random random);

/// Mean squared error of the velocity (column flow), views all given.
PhaseLoss poseFlowLoss(PoseFlow& network, const std::vector<PoseSample>& samples, Random random);

/// @param latents   [N, kShapeTokens, latent], normalised; rows as in LatentSample
/// @param dropout   share of samples whose view is not given
PhaseLoss shapeFlowLoss(ShapeFlow& network, const std::vector<LatentSample>& samples,
                        const torch::Tensor& latents, double dropout, Random random);

}  // namespace hydrabench

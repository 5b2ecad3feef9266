// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
//
// Includes libtorch: for the sources of core/shape/latent_flow, of the trainers and of tests only.
#pragma once

#include <memory>
#include <string>

#include "core/shape/latent_flow/latent_flow_model.h"
#include "core/shape/latent_flow/latent_flow_network.h"

namespace hydrabench {

/// A model with the weights that the networks have.
std::unique_ptr<const LatentFlowModel> makeLatentFlowModel(LatentFlowNetwork network,
                                                           const std::string& device);

/// Index of the row of [N, C] whose distances to all others add up to the least.
std::int64_t medoid(const torch::Tensor& rows);

}  // namespace hydrabench

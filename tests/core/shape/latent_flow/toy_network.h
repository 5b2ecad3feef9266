// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/shape/latent_flow/latent_flow_network.h"

namespace hydrabench {

/// Sizes with which a network takes a moment.
inline LatentFlowSizes toySizes() {
  LatentFlowSizes sizes;
  sizes.latent = 4;
  sizes.features = 4;
  sizes.hidden = 8;
  sizes.autoencoder_dim = 16;
  sizes.autoencoder_heads = 2;
  sizes.encoder_depth = 1;
  sizes.decoder_depth = 1;
  sizes.flow_dim = 16;
  sizes.flow_depth = 1;
  sizes.flow_heads = 2;
  sizes.pose_dim = 16;
  sizes.pose_depth = 1;
  sizes.pose_heads = 2;
  sizes.view_dim = 16;
  sizes.view_depth = 1;
  sizes.view_heads = 2;
  return sizes;
}

/// Weights drawn at random, those included that are zero before any training.
inline LatentFlowNetwork toyNetwork(std::uint64_t seed) {
  torch::manual_seed(seed);
  LatentFlowNetwork network(toySizes());
  const torch::NoGradGuard no_grad;
  for (torch::Tensor& value : network->parameters()) value.normal_(0, 0.3);
  return network;
}

}  // namespace hydrabench

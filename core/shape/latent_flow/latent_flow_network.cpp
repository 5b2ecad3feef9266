// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "core/shape/latent_flow/latent_flow_network.h"

namespace hydrabench {

ShapeAutoencoderImpl::Options autoencoderOptions(const LatentFlowSizes& sizes) {
  return {.dim = sizes.autoencoder_dim,
          .encoder_depth = sizes.encoder_depth,
          .decoder_depth = sizes.decoder_depth,
          .heads = sizes.autoencoder_heads,
          .latent = sizes.latent,
          .features = sizes.features,
          .hidden = sizes.hidden};
}

PoseFlowImpl::Options poseFlowOptions(const LatentFlowSizes& sizes) {
  return {.dim = sizes.pose_dim,
          .depth = sizes.pose_depth,
          .heads = sizes.pose_heads,
          .view = {.dim = sizes.view_dim, .depth = sizes.view_depth, .heads = sizes.view_heads}};
}

ShapeFlowImpl::Options shapeFlowOptions(const LatentFlowSizes& sizes) {
  return {.dim = sizes.flow_dim,
          .depth = sizes.flow_depth,
          .heads = sizes.flow_heads,
          .latent = sizes.latent};
}

}  // namespace hydrabench

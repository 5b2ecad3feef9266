// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
//
// Includes libtorch: for the sources of the trainers only.
#pragma once

#include <filesystem>

#include <torch/torch.h>

#include "core/shape/latent_flow/latent_flow_manifest.h"
#include "core/shape/latent_flow/pose_flow.h"
#include "core/shape/latent_flow/shape_autoencoder.h"
#include "core/shape/latent_flow/shape_flow.h"

namespace hydrabench {

ShapeAutoencoderImpl::Options autoencoderOptions(const LatentFlowSizes& sizes);
PoseFlowImpl::Options poseFlowOptions(const LatentFlowSizes& sizes);
ShapeFlowImpl::Options shapeFlowOptions(const LatentFlowSizes& sizes);

/// The three networks of a latent flow, as they stand in one file of weights.
class LatentFlowNetworkImpl : public torch::nn::Module {
 public:
  explicit LatentFlowNetworkImpl(const LatentFlowSizes& sizes)
      : autoencoder(register_module("autoencoder", ShapeAutoencoder(autoencoderOptions(sizes)))),
        pose(register_module("pose", PoseFlow(poseFlowOptions(sizes)))),
        shape(register_module("shape", ShapeFlow(shapeFlowOptions(sizes)))) {}

  ShapeAutoencoder autoencoder;
  PoseFlow pose;
  ShapeFlow shape;
};
TORCH_MODULE(LatentFlowNetwork);

}  // namespace hydrabench

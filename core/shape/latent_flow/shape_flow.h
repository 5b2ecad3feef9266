// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
//
// Includes libtorch: for the sources of core/shape/latent_flow, of the trainers and of tests only.
#pragma once

#include <torch/torch.h>

#include "core/shape/latent_flow/flow_block.h"
#include "core/shape/latent_flow/view_grid.h"

namespace hydrabench {

/// Velocity of latent voxels, given what a view measured in and around each of them.
class ShapeFlowImpl : public torch::nn::Module {
 public:
  struct Options {
    int dim = 192;
    int depth = 6;
    int heads = 6;
    int latent = 24;  ///< as ShapeAutoencoderImpl::Options
  };
  explicit ShapeFlowImpl(const Options& options);

  /// @param latent   [B, kShapeTokens, latent] x_t, normalised
  /// @param time     [B]
  /// @param cells    [B, kShapeTokens, ViewGrid::kBlockFeatures]
  /// @param globals  [B, ViewGrid::kGlobals]
  /// @param given    [B] 1 where the condition is given, 0 where the velocity is that of any shape
  torch::Tensor forward(const torch::Tensor& latent, const torch::Tensor& time,
                        const torch::Tensor& cells, const torch::Tensor& globals,
                        const torch::Tensor& given);
  const Options& options() const { return options_; }

 private:
  Options options_;
  torch::nn::Linear in_{nullptr};
  torch::nn::Sequential cells_;
  torch::nn::Sequential globals_;
  torch::Tensor position_;
  torch::Tensor unknown_;  ///< stands in for a condition that is not given
  TimeEmbedding time_{nullptr};
  torch::nn::ModuleList blocks_;
  FlowHead head_{nullptr};
};
TORCH_MODULE(ShapeFlow);

}  // namespace hydrabench

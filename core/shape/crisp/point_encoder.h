// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
//
// Includes libtorch: for the sources of core/shape/crisp, core/shape/latent_flow and of the
// trainers only.
#pragma once

#include <span>

#include <torch/torch.h>

#include "core/shape/crisp/point_input.h"
#include "core/shape/crisp/transformer_block.h"

namespace hydrabench {

/// Inputs of several views as tensors; B views.
struct PointBatch {
  torch::Tensor points;        ///< [B, kPoints, kFeatures]
  torch::Tensor patches;       ///< [B, kTokens, kPatch] int64
  torch::Tensor near;          ///< [B, kObjectPoints, kNear] int64
  torch::Tensor near_weights;  ///< [B, kObjectPoints, kNear]
  torch::Tensor globals;       ///< [B, kGlobals]
};
PointBatch makePointBatch(std::span<const PointInput> inputs);

/// Rows of each batch item: values [B, N, C], index [B, ...] -> [B, ..., C].
torch::Tensor gatherRows(const torch::Tensor& values, const torch::Tensor& index);

/// A transformer over patches of measured points: what the small CRISP network and the latent flow
/// know of a view.
class PointEncoderImpl : public torch::nn::Module {
 public:
  struct Options {
    int dim = 192;
    int depth = 6;
    int heads = 3;
  };
  explicit PointEncoderImpl(const Options& options);

  /// [B, 1 + kTokens, dim]: a summary of the view, then its patches, those of the object first.
  torch::Tensor tokens(const PointBatch& batch);

 private:
  torch::nn::Sequential patch_points_;
  torch::nn::Linear patch_{nullptr};
  torch::nn::Sequential position_;
  torch::nn::Sequential globals_;
  torch::Tensor kinds_;
  torch::nn::ModuleList blocks_;
  torch::nn::LayerNorm norm_{nullptr};
};
TORCH_MODULE(PointEncoder);

}  // namespace hydrabench

// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
//
// Includes libtorch: for the sources of core/shape/crisp and of the trainers only.
#pragma once

#include <torch/torch.h>

namespace hydrabench {

/// Multi-head self-attention. Names as in DINOv2: qkv, proj.
class SelfAttentionImpl : public torch::nn::Module {
 public:
  SelfAttentionImpl(int dim, int heads);
  torch::Tensor forward(const torch::Tensor& tokens);  ///< [B, N, dim] to the same

 private:
  int heads_;
  torch::nn::Linear qkv_{nullptr};
  torch::nn::Linear proj_{nullptr};
};
TORCH_MODULE(SelfAttention);

/// Pre-norm transformer block with LayerScale, as in DINOv2 (Oquab et al. 2023; names norm1, attn,
/// ls1, norm2, mlp, ls2): x + ls1 * attn(norm1 x), then x + ls2 * mlp(norm2 x); LayerNorm with
/// eps 1e-6, hidden width 4 dim, exact GELU.
class TransformerBlockImpl : public torch::nn::Module {
 public:
  TransformerBlockImpl(int dim, int heads);
  torch::Tensor forward(const torch::Tensor& tokens);  ///< [B, N, dim] to the same

 private:
  torch::nn::LayerNorm norm1_{nullptr};
  SelfAttention attention_{nullptr};
  torch::nn::ParameterDict scale1_;
  torch::nn::LayerNorm norm2_{nullptr};
  torch::nn::Linear fc1_{nullptr};
  torch::nn::Linear fc2_{nullptr};
  torch::nn::ParameterDict scale2_;
};
TORCH_MODULE(TransformerBlock);

}  // namespace hydrabench

// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
//
// Includes libtorch: for the sources of core/shape/latent_flow, of the trainers and of tests only.
#pragma once

#include <torch/torch.h>

#include "core/shape/crisp/transformer_block.h"

namespace hydrabench {

/// Features of a time in [0, 1]: sines and cosines of it, then two layers. [B] to [B, dim]
class TimeEmbeddingImpl : public torch::nn::Module {
 public:
  explicit TimeEmbeddingImpl(int dim);
  torch::Tensor forward(const torch::Tensor& time);

 private:
  torch::nn::Linear fc1_{nullptr};
  torch::nn::Linear fc2_{nullptr};
};
TORCH_MODULE(TimeEmbedding);

/// Attention of tokens to the tokens of something else.
class CrossAttentionImpl : public torch::nn::Module {
 public:
  CrossAttentionImpl(int dim, int context_dim, int heads);
  /// [K B, N, dim] and [B, M, context_dim] to [K B, N, dim]: each context serves K neighbours.
  torch::Tensor forward(const torch::Tensor& tokens, const torch::Tensor& context);

 private:
  int heads_;
  torch::nn::Linear q_{nullptr};
  torch::nn::Linear kv_{nullptr};
  torch::nn::Linear proj_{nullptr};
};
TORCH_MODULE(CrossAttention);

/// Transformer block whose norms are shifted, scaled and gated by a vector (adaLN-Zero: Peebles and
/// Xie, DiT, ICCV 2023): it is the identity at first. With a context it attends to that, too,
/// between attention among the tokens and the two layers.
class FlowBlockImpl : public torch::nn::Module {
 public:
  /// @param context_dim  0: no context
  FlowBlockImpl(int dim, int heads, int context_dim = 0);
  /// @param modulation  [B, dim]
  /// @param context     as CrossAttention's, undefined where there is none
  torch::Tensor forward(const torch::Tensor& tokens, const torch::Tensor& modulation,
                        const torch::Tensor& context = {});

 private:
  torch::nn::LayerNorm norm_{nullptr};
  torch::nn::LayerNorm context_norm_{nullptr};
  torch::nn::Linear modulation_{nullptr};
  SelfAttention attention_{nullptr};
  CrossAttention cross_{nullptr};
  torch::nn::Linear fc1_{nullptr};
  torch::nn::Linear fc2_{nullptr};
};
TORCH_MODULE(FlowBlock);

/// Last layer of a flow: a modulated norm, then a linear layer that is zero at first.
class FlowHeadImpl : public torch::nn::Module {
 public:
  FlowHeadImpl(int dim, int out);
  torch::Tensor forward(const torch::Tensor& tokens, const torch::Tensor& modulation);

 private:
  torch::nn::LayerNorm norm_{nullptr};
  torch::nn::Linear modulation_{nullptr};
  torch::nn::Linear out_{nullptr};
};
TORCH_MODULE(FlowHead);

}  // namespace hydrabench

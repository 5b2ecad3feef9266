// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "core/shape/latent_flow/flow_block.h"

#include <cmath>

namespace hydrabench {
namespace {

namespace nn = torch::nn;

constexpr int kFrequencies = 32;  // of a time

nn::LayerNorm plainNorm(int dim) {
  return nn::LayerNorm(nn::LayerNormOptions({dim}).eps(1e-6).elementwise_affine(false));
}

nn::Linear zeroLinear(int in, int out) {
  nn::Linear layer(in, out);
  const torch::NoGradGuard no_grad;
  layer->weight.zero_();
  layer->bias.zero_();
  return layer;
}

/// Norms work in single precision: libtorch 1.13 does not mix the two.
torch::Tensor modulated(nn::LayerNorm& norm, const torch::Tensor& x, const torch::Tensor& shift,
                        const torch::Tensor& scale) {
  return norm(x.to(torch::kFloat32)) * (1 + scale) + shift;
}

}  // namespace

TimeEmbeddingImpl::TimeEmbeddingImpl(int dim) {
  fc1_ = register_module("fc1", nn::Linear(2 * kFrequencies, dim));
  fc2_ = register_module("fc2", nn::Linear(dim, dim));
}

torch::Tensor TimeEmbeddingImpl::forward(const torch::Tensor& time) {
  // From one turn over the unit interval to some hundred.
  const torch::Tensor turns =
      torch::exp(torch::arange(kFrequencies, torch::kFloat32) * (std::log(100.0) / kFrequencies));
  const torch::Tensor angle = 6.2831853 * time.unsqueeze(1) * turns.to(time.device());
  return fc2_(torch::silu(fc1_(torch::cat({angle.sin(), angle.cos()}, 1))));
}

CrossAttentionImpl::CrossAttentionImpl(int dim, int context_dim, int heads) : heads_(heads) {
  q_ = register_module("q", nn::Linear(dim, dim));
  kv_ = register_module("kv", nn::Linear(context_dim, 2 * dim));
  proj_ = register_module("proj", nn::Linear(dim, dim));
}

torch::Tensor CrossAttentionImpl::forward(const torch::Tensor& tokens,
                                          const torch::Tensor& context) {
  // Queries do not see each other, so those of one context may as well be tokens of one sequence.
  const std::int64_t contexts = context.size(0);
  const std::int64_t count = tokens.size(0) / contexts * tokens.size(1);
  const std::int64_t dim = tokens.size(2);
  const torch::Tensor q =
      q_(tokens).reshape({contexts, count, heads_, dim / heads_}).permute({0, 2, 1, 3});
  const torch::Tensor kv = kv_(context)
                               .view({contexts, context.size(1), 2, heads_, dim / heads_})
                               .permute({2, 0, 3, 1, 4});
  const double scale = 1 / std::sqrt(static_cast<double>(dim / heads_));
  const torch::Tensor weights =
      torch::softmax(torch::matmul(q * scale, kv[0].transpose(-2, -1)), -1);
  return proj_(torch::matmul(weights, kv[1]).transpose(1, 2).reshape(tokens.sizes()));
}

FlowBlockImpl::FlowBlockImpl(int dim, int heads, int context_dim) {
  norm_ = register_module("norm", plainNorm(dim));
  modulation_ = register_module("modulation", zeroLinear(dim, 6 * dim));
  attention_ = register_module("attn", SelfAttention(dim, heads));
  if (context_dim > 0) {
    context_norm_ =
        register_module("context_norm", nn::LayerNorm(nn::LayerNormOptions({dim}).eps(1e-6)));
    cross_ = register_module("cross", CrossAttention(dim, context_dim, heads));
  }
  fc1_ = register_module("fc1", nn::Linear(dim, 4 * dim));
  fc2_ = register_module("fc2", nn::Linear(4 * dim, dim));
}

torch::Tensor FlowBlockImpl::forward(const torch::Tensor& tokens, const torch::Tensor& modulation,
                                     const torch::Tensor& context) {
  const std::vector<torch::Tensor> m =
      modulation_(torch::silu(modulation)).to(torch::kFloat32).unsqueeze(1).chunk(6, 2);
  torch::Tensor x = tokens + m[2] * attention_(modulated(norm_, tokens, m[0], m[1]));
  if (cross_ && context.defined()) x = x + cross_(context_norm_(x), context);
  return x + m[5] * fc2_(torch::gelu(fc1_(modulated(norm_, x, m[3], m[4]))));
}

FlowHeadImpl::FlowHeadImpl(int dim, int out) {
  norm_ = register_module("norm", plainNorm(dim));
  modulation_ = register_module("modulation", zeroLinear(dim, 2 * dim));
  out_ = register_module("out", zeroLinear(dim, out));
}

torch::Tensor FlowHeadImpl::forward(const torch::Tensor& tokens, const torch::Tensor& modulation) {
  const std::vector<torch::Tensor> m =
      modulation_(torch::silu(modulation)).to(torch::kFloat32).unsqueeze(1).chunk(2, 2);
  return out_(modulated(norm_, tokens, m[0], m[1])).to(torch::kFloat32);
}

}  // namespace hydrabench

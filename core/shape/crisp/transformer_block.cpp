// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "core/shape/crisp/transformer_block.h"

#include <cmath>

namespace hydrabench {

SelfAttentionImpl::SelfAttentionImpl(int dim, int heads) : heads_(heads) {
  qkv_ = register_module("qkv", torch::nn::Linear(dim, 3 * dim));
  proj_ = register_module("proj", torch::nn::Linear(dim, dim));
}

torch::Tensor SelfAttentionImpl::forward(const torch::Tensor& tokens) {
  const std::int64_t batch = tokens.size(0);
  const std::int64_t count = tokens.size(1);
  const std::int64_t dim = tokens.size(2);
  const torch::Tensor qkv =
      qkv_(tokens).view({batch, count, 3, heads_, dim / heads_}).permute({2, 0, 3, 1, 4});
  const double scale = 1 / std::sqrt(static_cast<double>(dim / heads_));
  const torch::Tensor weights =
      torch::softmax(torch::matmul(qkv[0] * scale, qkv[1].transpose(-2, -1)), -1);
  return proj_(torch::matmul(weights, qkv[2]).transpose(1, 2).reshape({batch, count, dim}));
}

TransformerBlockImpl::TransformerBlockImpl(int dim, int heads) {
  const auto norm = torch::nn::LayerNormOptions({dim}).eps(1e-6);
  norm1_ = register_module("norm1", torch::nn::LayerNorm(norm));
  attention_ = register_module("attn", SelfAttention(dim, heads));
  scale1_ = register_module("ls1", torch::nn::ParameterDict());
  scale1_->insert("gamma", torch::ones({dim}).set_requires_grad(true));
  norm2_ = register_module("norm2", torch::nn::LayerNorm(norm));
  fc1_ = torch::nn::Linear(dim, 4 * dim);
  fc2_ = torch::nn::Linear(4 * dim, dim);
  torch::OrderedDict<std::string, std::shared_ptr<torch::nn::Module>> named;
  named.insert("fc1", fc1_.ptr());
  named.insert("fc2", fc2_.ptr());
  register_module("mlp", torch::nn::ModuleDict())->update(named);
  scale2_ = register_module("ls2", torch::nn::ParameterDict());
  scale2_->insert("gamma", torch::ones({dim}).set_requires_grad(true));
}

torch::Tensor TransformerBlockImpl::forward(const torch::Tensor& tokens) {
  torch::Tensor x = tokens + scale1_["gamma"] * attention_(norm1_(tokens));
  return x + scale2_["gamma"] * fc2_(torch::gelu(fc1_(norm2_(x))));
}

}  // namespace hydrabench

// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "core/shape/latent_flow/pose_flow.h"

#include "core/shape/latent_flow/pose_tokens.h"

namespace hydrabench {

namespace nn = torch::nn;

PoseFlowImpl::PoseFlowImpl(const Options& options) : options_(options) {
  const int dim = options.dim;
  view_ = register_module("view", PointEncoder(options.view));
  in_ = register_module("input", nn::Linear(PoseTokens::kWidth, dim));
  summary_ = register_module("summary", nn::Linear(options.view.dim, dim));
  kinds_ = register_parameter("kinds", 0.02 * torch::randn({PoseTokens::kTokens, dim}));
  time_ = register_module("time", TimeEmbedding(dim));
  blocks_ = register_module("blocks", nn::ModuleList());
  for (int i = 0; i < options.depth; ++i) {
    blocks_->push_back(FlowBlock(dim, options.heads, options.view.dim));
  }
  head_ = register_module("head", FlowHead(dim, PoseTokens::kWidth));
}

torch::Tensor PoseFlowImpl::forward(const torch::Tensor& pose, const torch::Tensor& time,
                                    const torch::Tensor& view) {
  const torch::Tensor summary =
      summary_(view.select(1, 0)).repeat_interleave(pose.size(0) / view.size(0), 0);
  const torch::Tensor modulation = (time_(time) + summary).to(torch::kFloat32);
  torch::Tensor tokens = in_(pose).to(torch::kFloat32) + kinds_;
  for (const auto& block : *blocks_) {
    tokens = block->as<FlowBlock>()->forward(tokens, modulation, view);
  }
  return head_(tokens, modulation);
}

}  // namespace hydrabench

// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "core/shape/latent_flow/shape_flow.h"

#include "core/shape/latent_flow/latent_grid.h"

namespace hydrabench {

namespace nn = torch::nn;

ShapeFlowImpl::ShapeFlowImpl(const Options& options) : options_(options) {
  const int dim = options.dim;
  in_ = register_module("input", nn::Linear(options.latent, dim));
  cells_ = register_module("cells", nn::Sequential(nn::Linear(ViewGrid::kBlockFeatures, dim),
                                                   nn::GELU(), nn::Linear(dim, dim)));
  globals_ = register_module("globals", nn::Sequential(nn::Linear(ViewGrid::kGlobals, 64),
                                                       nn::GELU(), nn::Linear(64, dim)));
  position_ = register_parameter("position", 0.02 * torch::randn({kShapeTokens, dim}));
  unknown_ = register_parameter("unknown", torch::zeros({2, dim}));
  time_ = register_module("time", TimeEmbedding(dim));
  blocks_ = register_module("blocks", nn::ModuleList());
  for (int i = 0; i < options.depth; ++i) blocks_->push_back(FlowBlock(dim, options.heads));
  head_ = register_module("head", FlowHead(dim, options.latent));
}

torch::Tensor ShapeFlowImpl::forward(const torch::Tensor& latent, const torch::Tensor& time,
                                     const torch::Tensor& cells, const torch::Tensor& globals,
                                     const torch::Tensor& given) {
  const torch::Tensor known = given.view({-1, 1, 1});
  const torch::Tensor measured =
      known * cells_->forward(cells).to(torch::kFloat32) + (1 - known) * unknown_[0];
  const torch::Tensor whole = given.view({-1, 1}) * globals_->forward(globals).to(torch::kFloat32) +
                              (1 - given.view({-1, 1})) * unknown_[1];
  const torch::Tensor modulation = time_(time).to(torch::kFloat32) + whole;
  torch::Tensor tokens = in_(latent).to(torch::kFloat32) + measured + position_;
  for (const auto& block : *blocks_) tokens = block->as<FlowBlock>()->forward(tokens, modulation);
  return head_(tokens, modulation);
}

}  // namespace hydrabench

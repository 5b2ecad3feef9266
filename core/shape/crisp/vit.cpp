// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "core/shape/crisp/vit.h"

#include <cassert>
#include <memory>

namespace hydrabench {
namespace {

/// DINOv2 resamples its position embedding with the factor (patches + this) / stored patches, not
/// with the ratio of the sizes; that moves the sampling positions a little. Its weights with
/// registers were trained without.
constexpr double kScaleOffset = 0.1;

}  // namespace

VitImpl::VitImpl(const Options& options) : options_(options) {
  const std::int64_t dim = options.dim;
  cls_token_ = register_parameter("cls_token", torch::zeros({1, 1, dim}));
  pos_embed_ = register_parameter(
      "pos_embed", 0.02 * torch::randn({1, 1 + std::int64_t{options.grid} * options.grid, dim}));
  if (options.registers > 0) {
    register_tokens_ =
        register_parameter("register_tokens", torch::zeros({1, options.registers, dim}));
  }
  register_parameter("mask_token", torch::zeros({1, dim}));  // used in DINOv2's training only
  proj_ = torch::nn::Conv2d(
      torch::nn::Conv2dOptions(options.channels, dim, options.patch).stride(options.patch));
  register_module("patch_embed", std::make_shared<torch::nn::Module>())
      ->register_module("proj", proj_);
  blocks_ = register_module("blocks", torch::nn::ModuleList());
  for (int i = 0; i < options.depth; ++i) {
    blocks_->push_back(TransformerBlock(options.dim, options.heads));
  }
  // CRISP reads the blocks, not the end: part of the weights all the same.
  register_module("norm", torch::nn::LayerNorm(torch::nn::LayerNormOptions({dim}).eps(1e-6)));
}

torch::Tensor VitImpl::positionEmbedding(std::int64_t rows, std::int64_t columns) const {
  const std::int64_t grid = options_.grid;
  if (rows == grid && columns == grid) return pos_embed_;
  const torch::Tensor cls = pos_embed_.narrow(1, 0, 1);
  const torch::Tensor stored = pos_embed_.narrow(1, 1, grid * grid)
                                   .view({1, grid, grid, options_.dim})
                                   .permute({0, 3, 1, 2});
  torch::Tensor patches;
  if (options_.registers > 0) {
    patches = torch::_upsample_bicubic2d_aa(stored, {rows, columns}, /*align_corners=*/false);
  } else {
    const auto factor = [&](std::int64_t count) {
      return (static_cast<double>(count) + kScaleOffset) / static_cast<double>(grid);
    };
    patches = torch::upsample_bicubic2d(stored, {rows, columns}, /*align_corners=*/false,
                                        factor(rows), factor(columns));
  }
  return torch::cat({cls, patches.flatten(2).transpose(1, 2)}, 1);
}

torch::Tensor VitImpl::embed(const torch::Tensor& image) {
  const torch::Tensor patches = proj_(image);
  const std::int64_t batch = image.size(0);
  torch::Tensor tokens =
      torch::cat({cls_token_.expand({batch, -1, -1}), patches.flatten(2).transpose(1, 2)}, 1);
  tokens = tokens + positionEmbedding(patches.size(2), patches.size(3));
  if (options_.registers == 0) return tokens;
  return torch::cat({tokens.narrow(1, 0, 1), register_tokens_.expand({batch, -1, -1}),
                     tokens.narrow(1, 1, tokens.size(1) - 1)},
                    1);
}

std::vector<VitImpl::Tap> VitImpl::forward(const torch::Tensor& image,
                                           const std::vector<int>& taps) {
  assert(image.size(1) == options_.channels);
  assert(image.size(2) % options_.patch == 0 && image.size(3) % options_.patch == 0);
  const std::int64_t rows = image.size(2) / options_.patch;
  const std::int64_t columns = image.size(3) / options_.patch;
  torch::Tensor tokens = embed(image);
  std::vector<Tap> shown;
  for (int i = 0; i < options_.depth && shown.size() < taps.size(); ++i) {
    const auto block = static_cast<std::size_t>(i);
    tokens = blocks_->at<TransformerBlockImpl>(block).forward(tokens);
    if (taps[shown.size()] != i) continue;
    const torch::Tensor patches = tokens.narrow(1, 1 + options_.registers, rows * columns);
    shown.push_back(
        {patches.transpose(1, 2).reshape({-1, options_.dim, rows, columns}), tokens.select(1, 0)});
  }
  assert(shown.size() == taps.size());
  return shown;
}

}  // namespace hydrabench

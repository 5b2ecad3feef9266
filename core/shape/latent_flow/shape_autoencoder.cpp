// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "core/shape/latent_flow/shape_autoencoder.h"

#include "core/shape/crisp/torch_runtime.h"

namespace hydrabench {
namespace {

namespace nn = torch::nn;
namespace functional = torch::nn::functional;

constexpr int kNodes = kNodesPerBlock * kNodesPerBlock * kNodesPerBlock;
constexpr int kCells = kCellsPerBlock * kCellsPerBlock * kCellsPerBlock;

torch::Tensor through(nn::ModuleList& blocks, torch::Tensor tokens) {
  for (const auto& block : *blocks) tokens = block->as<TransformerBlock>()->forward(tokens);
  return tokens;
}

}  // namespace

torch::Tensor toBlocks(const torch::Tensor& values, int side) {
  const std::int64_t batch = values.size(0);
  const int n = side / kBlockSide;
  return values.view({batch, kBlockSide, n, kBlockSide, n, kBlockSide, n, -1})
      .permute({0, 1, 3, 5, 2, 4, 6, 7})
      .reshape({batch, kShapeTokens, -1});
}

torch::Tensor fromBlocks(const torch::Tensor& blocks, int side) {
  const std::int64_t batch = blocks.size(0);
  const int n = side / kBlockSide;
  return blocks.view({batch, kBlockSide, kBlockSide, kBlockSide, n, n, n, -1})
      .permute({0, 1, 4, 2, 5, 3, 6, 7})
      .reshape({batch, side * side * side, -1});
}

ShapeAutoencoderImpl::ShapeAutoencoderImpl(const Options& options) : options_(options) {
  const int dim = options.dim;
  const auto norm = nn::LayerNormOptions({dim}).eps(1e-6);
  in_ = register_module("input", nn::Linear(kNodes, dim));
  position_ = register_parameter("position", 0.02 * torch::randn({2, kShapeTokens, dim}));
  encoder_ = register_module("encoder", nn::ModuleList());
  for (int i = 0; i < options.encoder_depth; ++i) {
    encoder_->push_back(TransformerBlock(dim, options.heads));
  }
  encoder_norm_ = register_module("encoder_norm", nn::LayerNorm(norm));
  to_latent_ = register_module("to_latent", nn::Linear(dim, options.latent));
  from_latent_ = register_module("from_latent", nn::Linear(options.latent, dim));
  decoder_ = register_module("decoder", nn::ModuleList());
  for (int i = 0; i < options.decoder_depth; ++i) {
    decoder_->push_back(TransformerBlock(dim, options.heads));
  }
  decoder_norm_ = register_module("decoder_norm", nn::LayerNorm(norm));
  to_cells_ = register_module("to_cells", nn::Linear(dim, kCells * options.features));
  field_ = register_module(
      "field", nn::Sequential(nn::Linear(options.features + 3, options.hidden), nn::GELU(),
                              nn::Linear(options.hidden, options.hidden), nn::GELU(),
                              nn::Linear(options.hidden, 1)));
  mean_ = register_buffer("mean", torch::zeros({options.latent}));
  deviation_ = register_buffer("deviation", torch::ones({options.latent}));
}

torch::Tensor ShapeAutoencoderImpl::encode(const torch::Tensor& grid) {
  const torch::Tensor tokens = in_(toBlocks(grid.unsqueeze(2), kGridSide)) + position_[0];
  return to_latent_(encoder_norm_(through(encoder_, tokens.to(torch::kFloat32))))
      .to(torch::kFloat32);
}

torch::Tensor ShapeAutoencoderImpl::decode(const torch::Tensor& latent) {
  const torch::Tensor tokens = from_latent_(latent) + position_[1];
  const torch::Tensor cells =
      to_cells_(decoder_norm_(through(decoder_, tokens.to(torch::kFloat32)))).to(torch::kFloat32);
  return fromBlocks(cells, kCellSide)
      .transpose(1, 2)
      .reshape({latent.size(0), options_.features, kCellSide, kCellSide, kCellSide});
}

torch::Tensor ShapeAutoencoderImpl::distance(const torch::Tensor& features,
                                             const torch::Tensor& points) {
  const std::int64_t batch = points.size(0);
  const std::int64_t count = points.size(1);
  const auto how = functional::GridSampleFuncOptions()
                       .mode(torch::kBilinear)
                       .padding_mode(torch::kBorder)
                       .align_corners(false);
  const torch::Tensor places = (points / kGridHalfSide).view({batch, 1, 1, count, 3});
  const torch::Tensor around =
      functional::grid_sample(features, places, how).view({batch, -1, count}).transpose(1, 2);
  return kTruncation *
         field_->forward(torch::cat({around, points}, 2)).to(torch::kFloat32).squeeze(2);
}

void ShapeAutoencoderImpl::setNormalization(const torch::Tensor& mean,
                                            const torch::Tensor& deviation) {
  const torch::NoGradGuard no_grad;
  mean_.copy_(mean);
  deviation_.copy_(deviation);
}

SdfField makeLatentField(ShapeAutoencoder autoencoder, const torch::Tensor& features) {
  return [autoencoder, features](std::span<const Eigen::Vector3f> points,
                                 std::span<float> values) mutable {
    keepTorchOnThisThread();
    const torch::NoGradGuard no_grad;
    const auto count = static_cast<std::int64_t>(points.size());
    const torch::Tensor places =
        torch::from_blob(const_cast<float*>(points.front().data()), {1, count, 3});
    const torch::Tensor inside = places.clamp(-kGridHalfSide, kGridHalfSide);
    const torch::Tensor beyond = (places - inside).norm(2, 2);
    const torch::Tensor distance =
        (autoencoder->distance(features, inside.to(features.device())).to(torch::kCPU) + beyond)
            .contiguous();
    std::copy_n(distance.data_ptr<float>(), values.size(), values.begin());
  };
}

}  // namespace hydrabench

// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "core/shape/crisp/crisp_network.h"

#include <cassert>
#include <memory>

#include "core/shape/crisp/torch_weights.h"

namespace hydrabench {
namespace nn = torch::nn;

CrispNetworkImpl::CrispNetworkImpl(const Options& options) : options_(options) {
  assert(options.head.dim == options.vit.dim);
  backbone_ = register_module("backbone", Vit(options.vit));
  head_ = register_module("nocs_net", DptHead(options.head));
  decoder_ = FilmSdf(options.decoder);
  const int width = options.code_width;
  const auto norm = nn::LayerNormOptions({width});
  code_layers_ = nn::Sequential(nn::Linear(5 * options.vit.dim, width), nn::LayerNorm(norm),
                                nn::ReLU(), nn::Linear(width, width), nn::LayerNorm(norm),
                                nn::ReLU(), nn::Linear(width, width), nn::LayerNorm(norm),
                                nn::ReLU(), nn::Linear(width, decoder_->modulationSize()));
  register_module("recons_backbone_adaptor", std::make_shared<nn::Module>())
      ->register_module("net", code_layers_);
  register_module("recons_net", decoder_);
  if (!options.train_backbone) {
    for (torch::Tensor& parameter : backbone_->parameters()) parameter.set_requires_grad(false);
  }
}

std::vector<VitImpl::Tap> CrispNetworkImpl::features(const torch::Tensor& image) {
  const torch::AutoGradMode gradient(options_.train_backbone && torch::GradMode::is_enabled());
  const std::int64_t side = options_.input_side;
  const bool fits = image.size(2) == side && image.size(3) == side;
  return backbone_->forward(
      fits ? image : torch::upsample_bilinear2d(image, {side, side}, /*align_corners=*/false),
      {options_.taps.begin(), options_.taps.end()});
}

CrispNetworkImpl::Output CrispNetworkImpl::predict(const std::vector<VitImpl::Tap>& taps) {
  std::vector<torch::Tensor> global;
  for (const VitImpl::Tap& tap : taps) global.push_back(tap.cls);
  global.push_back(taps.back().patches.mean({2, 3}));
  return {head_->forward(taps, options_.input_side), code_layers_->forward(torch::cat(global, 1))};
}

CrispNetworkImpl::Output CrispNetworkImpl::forward(const torch::Tensor& image) {
  return predict(features(image));
}

CrispNetwork loadCrispNetwork(const CrispManifest& manifest) {
  assert(manifest.preset == "full");
  CrispNetworkImpl::Options options;
  options.decoder.layers = manifest.sdf_layers;
  options.decoder.width = manifest.sdf_width;
  CrispNetwork network(options);
  loadWeights(*network, manifest.weights);
  network->eval();
  return network;
}

}  // namespace hydrabench

// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "core/shape/crisp/film_sdf.h"

#include <cmath>
#include <memory>
#include <string>

namespace hydrabench {

FilmSdfImpl::FilmSdfImpl(const Options& options) : options_(options) {
  const torch::NoGradGuard no_grad;
  // The container of containers gives the names of CRISP's checkpoints: filmed_sdf.i.0.layer.
  torch::nn::ModuleList stack;
  for (int i = 0; i < options.layers; ++i) {
    torch::nn::Linear linear(i == 0 ? 3 : options.width, options.width);
    const double range = i == 0 ? options.first_range : std::sqrt(6.0 / options.width);
    linear->weight.uniform_(-range, range);
    torch::OrderedDict<std::string, std::shared_ptr<torch::nn::Module>> named;
    named.insert("layer", linear.ptr());
    torch::nn::ModuleDict sine;
    sine->update(named);
    torch::nn::ModuleList block;
    block->push_back(sine);
    stack->push_back(block);
    layers_.push_back(linear);
  }
  register_module("filmed_sdf", stack);
  final_ = register_module("final_layer", torch::nn::Linear(options.width, 1));
}

torch::Tensor FilmSdfImpl::forward(const torch::Tensor& points, const torch::Tensor& modulation) {
  torch::Tensor x = points;
  const torch::Tensor film = modulation.view({-1, options_.layers, 2, options_.width});
  for (int i = 0; i < options_.layers; ++i) {
    torch::Tensor gain = film.select(1, i).select(1, 0).unsqueeze(1);  // [B, 1, width]
    const torch::Tensor shift = film.select(1, i).select(1, 1).unsqueeze(1);
    if (options_.residual_gain) gain = gain + 1;
    x = torch::sin(torch::addcmul(shift, gain, layers_[static_cast<std::size_t>(i)](x)));
  }
  return final_(x).squeeze(-1);
}

}  // namespace hydrabench

// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "core/shape/crisp/film_field.h"

#include <algorithm>
#include <cassert>
#include <string>
#include <vector>

#include "core/shape/crisp/torch_runtime.h"

namespace hydrabench {
namespace {

/// y = x weight + bias.
struct Layer {
  torch::Tensor weight;  ///< [in, out]
  torch::Tensor bias;    ///< [out]
};

struct FoldedDecoder {
  std::vector<Layer> sines;
  Layer last;

  void operator()(std::span<const Eigen::Vector3f> points, std::span<float> values) const {
    static_assert(sizeof(Eigen::Vector3f) == 3 * sizeof(float));
    keepTorchOnThisThread();
    const torch::NoGradGuard no_grad;
    const auto count = static_cast<std::int64_t>(points.size());
    // from_blob wants a pointer to what could be written; nothing below writes there.
    torch::Tensor x = torch::from_blob(const_cast<float*>(points.data()->data()), {count, 3});
    x = x.to(last.weight.device());
    for (const Layer& layer : sines) x = torch::addmm(layer.bias, x, layer.weight).sin_();
    const torch::Tensor y = torch::addmm(last.bias, x, last.weight).to(torch::kCPU).contiguous();
    std::copy_n(y.data_ptr<float>(), values.size(), values.begin());
  }
};

}  // namespace

SdfField makeFilmField(const FilmSdfImpl& decoder, const torch::Tensor& modulation) {
  const torch::NoGradGuard no_grad;
  const FilmSdfImpl::Options& options = decoder.options();
  assert(modulation.numel() == decoder.modulationSize());
  const torch::Tensor film =
      modulation.detach().to(torch::kFloat32).view({options.layers, 2, options.width});
  const auto parameters = decoder.named_parameters();
  FoldedDecoder folded;
  for (int i = 0; i < options.layers; ++i) {
    const std::string name = "filmed_sdf." + std::to_string(i) + ".0.layer.";
    const torch::Tensor gain = film[i][0] + (options.residual_gain ? 1.0 : 0.0);
    const torch::Tensor weight = parameters[name + "weight"] * gain.unsqueeze(1);
    folded.sines.push_back(
        {weight.t().contiguous(), parameters[name + "bias"] * gain + film[i][1]});
  }
  folded.last = {parameters["final_layer.weight"].t().clone(at::MemoryFormat::Contiguous),
                 parameters["final_layer.bias"].clone()};
  return folded;
}

}  // namespace hydrabench

// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "core/shape/crisp/point_network.h"

namespace hydrabench {
namespace {

namespace nn = torch::nn;

constexpr int kOwnWidth = 64;
constexpr int kShapeWidth = 512;

}  // namespace

PointNetworkImpl::PointNetworkImpl(const Options& options)
    : PointEncoderImpl({options.dim, options.depth, options.heads}), options_(options) {
  const int dim = options.dim;
  own_point_ = register_module(
      "own_point", nn::Sequential(nn::Linear(PointInput::kFeatures, kOwnWidth), nn::GELU()));
  dense_ =
      register_module("dense", nn::Sequential(nn::Linear(2 * dim + kOwnWidth, dim), nn::GELU(),
                                              nn::Linear(dim, 96), nn::GELU(), nn::Linear(96, 6)));
  // Half-precision activations meet single-precision norms, which libtorch 1.13 does not mix.
  const nn::Functional single([](const torch::Tensor& x) { return x.to(torch::kFloat32); });
  const auto norm = nn::LayerNormOptions({kShapeWidth});
  shape_ = register_module(
      "shape",
      nn::Sequential(nn::Linear(3 * dim, kShapeWidth), single, nn::LayerNorm(norm), nn::GELU(),
                     nn::Linear(kShapeWidth, kShapeWidth), single, nn::LayerNorm(norm), nn::GELU(),
                     nn::Linear(kShapeWidth, options.code)));
  direct_ = register_module(
      "direct", nn::Sequential(nn::Linear(3 * dim, 256), nn::GELU(), nn::Linear(256, 6)));
  decoder_ = register_module("decoder", FilmSdf(options.decoder));
  modulation_ = register_module("modulation", nn::Linear(options.code, decoder_->modulationSize()));
  const torch::NoGradGuard no_grad;
  modulation_->weight.mul_(0.25);
  modulation_->bias.zero_();
}

PointNetworkImpl::Output PointNetworkImpl::forward(const PointBatch& batch) {
  const torch::Tensor all = tokens(batch);
  const torch::Tensor summary = all.select(1, 0);
  const torch::Tensor object = all.narrow(1, 1, PointInput::kObjectTokens);
  const torch::Tensor global = torch::cat({summary, object.mean(1), object.amax(1)}, -1);

  const torch::Tensor own = batch.points.narrow(1, 0, PointInput::kObjectPoints);
  const torch::Tensor around =
      (gatherRows(object, batch.near) * batch.near_weights.unsqueeze(-1).to(object.scalar_type()))
          .sum(2);
  const torch::Tensor everywhere = summary.unsqueeze(1).expand({-1, PointInput::kObjectPoints, -1});
  const torch::Tensor vote =
      dense_->forward(torch::cat({around, everywhere, own_point_->forward(own)}, -1))
          .to(torch::kFloat32);
  // Each point votes for an upright similarity, applied to itself: a turn and scale in the plane
  // (a, b), a centre, a vertical scale.
  const torch::Tensor from_center = own.narrow(2, 0, 3) - vote.narrow(2, 2, 3);
  const torch::Tensor a = vote.select(2, 0);
  const torch::Tensor b = vote.select(2, 1);
  const torch::Tensor x = from_center.select(2, 0);
  const torch::Tensor y = from_center.select(2, 1);
  Output output;
  output.nocs = torch::stack(
      {a * x + b * y, a * y - b * x, (1 + vote.select(2, 5)) * from_center.select(2, 2)}, -1);
  output.code = shape_->forward(global).to(torch::kFloat32);
  output.direct = direct_->forward(global).to(torch::kFloat32);
  return output;
}

torch::Tensor PointNetworkImpl::sdf(const torch::Tensor& points, const torch::Tensor& code) {
  return decoder_(points, modulation_(code));
}

}  // namespace hydrabench

// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "core/shape/crisp/point_encoder.h"

#include <algorithm>
#include <vector>

namespace hydrabench {
namespace {

namespace nn = torch::nn;

constexpr int kPatchWidth = 128;
/// Offsets within a patch are small in local units; this brings them to the size of the rest.
constexpr double kPatchGain = 4;

template <typename Value>
torch::Tensor stack(std::span<const PointInput> inputs, std::vector<Value> PointInput::*field,
                    torch::ScalarType type, std::vector<std::int64_t> shape) {
  shape.insert(shape.begin(), static_cast<std::int64_t>(inputs.size()));
  torch::Tensor result = torch::empty(shape, type);
  Value* out = result.data_ptr<Value>();
  for (const PointInput& input : inputs) {
    out = std::copy((input.*field).begin(), (input.*field).end(), out);
  }
  return result;
}

}  // namespace

torch::Tensor gatherRows(const torch::Tensor& values, const torch::Tensor& index) {
  const std::int64_t batch = values.size(0);
  const std::int64_t count = values.size(1);
  const torch::Tensor offset = (torch::arange(batch, index.options()) * count).view({batch, 1, 1});
  std::vector<std::int64_t> shape = index.sizes().vec();
  shape.push_back(values.size(2));
  return values.reshape({batch * count, -1})
      .index_select(0, (index + offset).flatten())
      .view(shape);
}

PointBatch makePointBatch(std::span<const PointInput> inputs) {
  using I = PointInput;
  PointBatch batch;
  batch.points = stack(inputs, &I::points, torch::kFloat32, {I::kPoints, I::kFeatures});
  batch.patches = stack(inputs, &I::patches, torch::kInt64, {I::kTokens, I::kPatch});
  batch.near = stack(inputs, &I::near, torch::kInt64, {I::kObjectPoints, I::kNear});
  batch.near_weights =
      stack(inputs, &I::near_weights, torch::kFloat32, {I::kObjectPoints, I::kNear});
  batch.globals = torch::empty({static_cast<std::int64_t>(inputs.size()), I::kGlobals});
  float* out = batch.globals.data_ptr<float>();
  for (const PointInput& input : inputs) {
    out = std::copy(input.globals.begin(), input.globals.end(), out);
  }
  return batch;
}

PointEncoderImpl::PointEncoderImpl(const Options& options) {
  const int dim = options.dim;
  patch_points_ = register_module(
      "patch_points", nn::Sequential(nn::Linear(3 + PointInput::kFeatures, 64), nn::GELU(),
                                     nn::Linear(64, kPatchWidth), nn::GELU(),
                                     nn::Linear(kPatchWidth, kPatchWidth)));
  patch_ = register_module("patch", nn::Linear(2 * kPatchWidth, dim));
  position_ = register_module("position",
                              nn::Sequential(nn::Linear(4, 64), nn::GELU(), nn::Linear(64, dim)));
  globals_ = register_module("globals", nn::Sequential(nn::Linear(PointInput::kGlobals, 128),
                                                       nn::GELU(), nn::Linear(128, dim)));
  kinds_ = register_parameter("kinds", 0.02 * torch::randn({3, dim}));
  blocks_ = register_module("blocks", nn::ModuleList());
  for (int i = 0; i < options.depth; ++i) blocks_->push_back(TransformerBlock(dim, options.heads));
  norm_ = register_module("norm", nn::LayerNorm(nn::LayerNormOptions({dim}).eps(1e-6)));
}

torch::Tensor PointEncoderImpl::tokens(const PointBatch& batch) {
  const torch::Tensor members = gatherRows(batch.points, batch.patches);  // [B, T, K, F]
  const torch::Tensor centers = members.select(2, 0);
  const torch::Tensor offsets =
      kPatchGain * (members.narrow(3, 0, 3) - centers.narrow(2, 0, 3).unsqueeze(2));
  const torch::Tensor embedded = patch_points_->forward(torch::cat({offsets, members}, -1));
  const torch::Tensor pooled = torch::cat({embedded.amax(2), embedded.mean(2)}, -1);
  torch::Tensor tokens = patch_(pooled) + position_->forward(centers.narrow(2, 0, 4));
  const torch::Tensor kinds = torch::cat({kinds_[1].expand({PointInput::kObjectTokens, -1}),
                                          kinds_[2].expand({PointInput::kContextTokens, -1})});
  tokens = tokens + kinds;
  const torch::Tensor summary = (globals_->forward(batch.globals) + kinds_[0]).unsqueeze(1);
  tokens = torch::cat({summary.to(tokens.scalar_type()), tokens}, 1);
  for (const auto& block : *blocks_) tokens = block->as<TransformerBlock>()->forward(tokens);
  return norm_(tokens);
}

}  // namespace hydrabench

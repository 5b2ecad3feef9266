// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
//
// Includes libtorch: for the sources of core/shape/latent_flow, of the trainers and of tests only.
#pragma once

#include <torch/torch.h>

#include "core/shape/crisp/point_encoder.h"
#include "core/shape/latent_flow/flow_block.h"

namespace hydrabench {

/// Velocity of the pose tokens (pose_tokens.h), which attend to the patches of measured points of a
/// view. The encoder is asked once per view, the rest once per step.
class PoseFlowImpl : public torch::nn::Module {
 public:
  struct Options {
    int dim = 128;
    int depth = 3;
    int heads = 4;
    PointEncoderImpl::Options view;
  };
  explicit PoseFlowImpl(const Options& options);

  /// [B, M, view.dim]
  torch::Tensor view(const PointBatch& batch) { return view_->tokens(batch); }
  /// @param pose  [K B, PoseTokens::kTokens, PoseTokens::kWidth] x_t, K neighbours of each view
  /// @param time  [K B]
  /// @param view  [B, M, view.dim], of view()
  torch::Tensor forward(const torch::Tensor& pose, const torch::Tensor& time,
                        const torch::Tensor& view);
  PointEncoder encoder() { return view_; }
  const Options& options() const { return options_; }

 private:
  Options options_;
  PointEncoder view_{nullptr};
  torch::nn::Linear in_{nullptr};
  torch::nn::Linear summary_{nullptr};
  torch::Tensor kinds_;
  TimeEmbedding time_{nullptr};
  torch::nn::ModuleList blocks_;
  FlowHead head_{nullptr};
};
TORCH_MODULE(PoseFlow);

}  // namespace hydrabench

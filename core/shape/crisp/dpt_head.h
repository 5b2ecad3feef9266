// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
//
// Includes libtorch: for the sources of core/shape/crisp and of the trainers only.
#pragma once

#include <array>
#include <vector>

#include <torch/torch.h>

#include "core/shape/crisp/vit.h"

namespace hydrabench {

/// Sizes of the DPT head; the defaults are CRISP's.
struct DptOptions {
  int dim = 384;                                         ///< of the tokens
  std::array<int, 4> tap_channels = {48, 96, 192, 384};  ///< of the map made from each tap
  int channels = 256;                                    ///< while fusing; a multiple of the groups
  int head_channels = 128;                               ///< before the last enlargement
  int last_channels = 32;
  int norm_groups = 4;
};

/// Tokens of four blocks as maps of 4, 2, 1 and 1/2 times the patch grid; each patch reads the
/// class token.
class DptReassembleImpl : public torch::nn::Module {
 public:
  explicit DptReassembleImpl(const DptOptions& options);
  std::vector<torch::Tensor> forward(const std::vector<VitImpl::Tap>& taps);

 private:
  torch::nn::ModuleList projects_;
  torch::nn::ModuleList resize_layers_;
  torch::nn::ModuleList readout_projects_;
};
TORCH_MODULE(DptReassemble);

/// x + norm(conv(relu(norm(conv(relu x))))).
class DptResidualUnitImpl : public torch::nn::Module {
 public:
  explicit DptResidualUnitImpl(const DptOptions& options);
  torch::Tensor forward(const torch::Tensor& input);

 private:
  torch::nn::Conv2d conv1_{nullptr};
  torch::nn::Conv2d conv2_{nullptr};
  torch::nn::GroupNorm norm1_{nullptr};
  torch::nn::GroupNorm norm2_{nullptr};
};
TORCH_MODULE(DptResidualUnit);

/// Adds the finer map to the coarser one, then doubles the size.
class DptFusionImpl : public torch::nn::Module {
 public:
  DptFusionImpl(const DptOptions& options, bool has_skip);
  /// @param skip  undefined in the deepest block, which has none
  torch::Tensor forward(torch::Tensor x, const torch::Tensor& skip);

 private:
  torch::nn::Conv2d project_{nullptr};
  DptResidualUnit unit1_{nullptr};
  DptResidualUnit unit2_{nullptr};
};
TORCH_MODULE(DptFusion);

/// Dense prediction head (Ranftl et al., ICCV 2021) as CRISP uses it for normalised object
/// coordinates: GroupNorm, no activation at the end. Parameters bear the names of CRISP's
/// checkpoints; the group norms are called "bn" there.
class DptHeadImpl : public torch::nn::Module {
 public:
  explicit DptHeadImpl(const DptOptions& options);

  /// @param taps  four, from shallow to deep
  /// @return      [B, 3, side, side]
  torch::Tensor forward(const std::vector<VitImpl::Tap>& taps, int side);

 private:
  DptReassemble reassemble_{nullptr};
  torch::nn::ModuleList convs_;
  torch::nn::ModuleList fusion_blocks_;
  torch::nn::Conv2d project_{nullptr};
  torch::nn::Conv2d conv1_{nullptr};
  torch::nn::GroupNorm norm_{nullptr};
  torch::nn::Conv2d conv2_{nullptr};
  torch::nn::Conv2d conv3_{nullptr};
};
TORCH_MODULE(DptHead);

}  // namespace hydrabench

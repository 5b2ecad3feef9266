// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
//
// Includes libtorch: for the sources of core/shape/crisp and of the trainers only.
#pragma once

#include <cstdint>
#include <vector>

#include <torch/torch.h>

#include "core/shape/crisp/transformer_block.h"

namespace hydrabench {

/// Vision transformer with DINOv2's layout and names (Oquab et al. 2023), so that its published
/// weights fit: patch embedding, class token, position embedding, LayerScale. The defaults are
/// ViT-S/14.
class VitImpl : public torch::nn::Module {
 public:
  struct Options {
    int dim = 384;
    int depth = 12;
    int heads = 6;
    int patch = 14;  ///< side of a patch [px]
    int grid = 37;   ///< patches along the side that the position embedding is stored for
    int channels = 3;
    int registers = 0;  ///< tokens after the class token that no tap shows: 4 in "_reg" weights
  };
  explicit VitImpl(const Options& options);

  /// What a block puts out, without the final norm.
  struct Tap {
    torch::Tensor patches;  ///< [B, dim, H / patch, W / patch]
    torch::Tensor cls;      ///< [B, dim]
  };
  /// @param image  [B, channels, H, W], sides multiples of the patch
  /// @param taps   blocks to show, from 0, ascending; nothing after the last of them is computed
  std::vector<Tap> forward(const torch::Tensor& image, const std::vector<int>& taps);

  /// The stored position embedding for a grid of patches: [1, 1 + rows * columns, dim].
  torch::Tensor positionEmbedding(std::int64_t rows, std::int64_t columns) const;
  const Options& options() const { return options_; }

 private:
  torch::Tensor embed(const torch::Tensor& image);

  Options options_;
  torch::nn::Conv2d proj_{nullptr};  ///< patches to tokens
  torch::Tensor cls_token_;
  torch::Tensor pos_embed_;
  torch::Tensor register_tokens_;
  torch::nn::ModuleList blocks_;
};
TORCH_MODULE(Vit);

}  // namespace hydrabench

// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
//
// Includes libtorch: for the sources of core/shape/latent_flow, of the trainers and of tests only.
#pragma once

#include <torch/torch.h>

#include "core/shape/crisp/transformer_block.h"
#include "core/shape/latent_flow/latent_grid.h"
#include "core/shape/sdf_mesher.h"

namespace hydrabench {

/// Distance fields to latent voxels and back. The encoder sees the field at the nodes of the grid
/// (latent_grid.h), a block a token; the decoder makes features at the cells from the latent
/// blocks, and a distance from the features around a point (as in Peng et al., Convolutional
/// Occupancy Networks, ECCV 2020), so that parts thinner than a node's distance are kept.
class ShapeAutoencoderImpl : public torch::nn::Module {
 public:
  struct Options {
    int dim = 192;
    int encoder_depth = 1;
    int decoder_depth = 2;
    int heads = 6;
    int latent = 24;    ///< channels of a block
    int features = 24;  ///< of a cell
    int hidden = 64;    ///< of the layers between features and distance
  };
  explicit ShapeAutoencoderImpl(const Options& options);

  /// @param grid  [B, kGridSide^3] distances over kTruncation, in [-1, 1]
  /// @return      [B, kShapeTokens, latent], of no particular size: see normalize()
  torch::Tensor encode(const torch::Tensor& grid);
  /// Latent blocks to features at the cells: [B, features, kCellSide, kCellSide, kCellSide], the
  /// axes z, y, x.
  torch::Tensor decode(const torch::Tensor& latent);
  /// Distances in units of the frame. @param points [B, N, 3], @return [B, N]
  torch::Tensor distance(const torch::Tensor& features, const torch::Tensor& points);

  /// Latents whose channels have mean 0 and deviation 1 over all shapes: what the flow works on.
  torch::Tensor normalize(const torch::Tensor& latent) { return (latent - mean_) / deviation_; }
  torch::Tensor denormalize(const torch::Tensor& latent) { return latent * deviation_ + mean_; }
  void setNormalization(const torch::Tensor& mean, const torch::Tensor& deviation);

  const Options& options() const { return options_; }

 private:
  Options options_;
  torch::nn::Linear in_{nullptr};
  torch::Tensor position_;
  torch::nn::ModuleList encoder_;
  torch::nn::LayerNorm encoder_norm_{nullptr};
  torch::nn::Linear to_latent_{nullptr};
  torch::nn::Linear from_latent_{nullptr};
  torch::nn::ModuleList decoder_;
  torch::nn::LayerNorm decoder_norm_{nullptr};
  torch::nn::Linear to_cells_{nullptr};
  torch::nn::Sequential field_;
  torch::Tensor mean_;
  torch::Tensor deviation_;
};
TORCH_MODULE(ShapeAutoencoder);

/// Values at the nodes or cells of the cube, sorted by blocks: [B, side^3 (z, y, x), C] to
/// [B, kShapeTokens, (side / kBlockSide)^3 * C], and back.
torch::Tensor toBlocks(const torch::Tensor& values, int side);
torch::Tensor fromBlocks(const torch::Tensor& blocks, int side);

/// The field of one shape, fast to ask: keeps the features, evaluates on the calling thread. Points
/// beyond the cube have the distance of the nearest point of it, and a little more.
SdfField makeLatentField(ShapeAutoencoder autoencoder, const torch::Tensor& features);

}  // namespace hydrabench

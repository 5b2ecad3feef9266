// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
//
// Includes libtorch: for the sources of core/shape/crisp and of the trainers only.
#pragma once

#include <torch/torch.h>

#include "core/shape/crisp/film_sdf.h"
#include "core/shape/crisp/point_encoder.h"

namespace hydrabench {

/// The small CRISP network. It keeps CRISP's parts (a transformer encoder, dense NOCS for pose and
/// scale, a code z in R^256 that modulates a FiLM-sine SDF decoder) and departs from it in its
/// input: tokens are patches of measured points instead of image patches, colour is not used.
class PointNetworkImpl : public PointEncoderImpl {
 public:
  struct Options {
    int dim = 192;
    int depth = 6;
    int heads = 3;
    int code = 256;
    FilmSdfImpl::Options decoder;
  };
  struct Output {
    torch::Tensor nocs;    ///< [B, kObjectPoints, 3]
    torch::Tensor code;    ///< [B, code]
    torch::Tensor direct;  ///< [B, 6] box centre (local frame), log half extent (local units), cos
                           ///< and sin of the object's yaw in the local frame (not normalised)
  };
  explicit PointNetworkImpl(const Options& options);

  Output forward(const PointBatch& batch);
  /// Distances in object coordinates. @param points [B, N, 3], @param code [B, code], @return [B,
  /// N]
  torch::Tensor sdf(const torch::Tensor& points, const torch::Tensor& code);

  torch::nn::Linear modulation() { return modulation_; }
  FilmSdf decoder() { return decoder_; }
  const Options& options() const { return options_; }

 private:
  Options options_;
  torch::nn::Sequential own_point_;
  torch::nn::Sequential dense_;
  torch::nn::Sequential shape_;
  torch::nn::Sequential direct_;
  torch::nn::Linear modulation_{nullptr};
  FilmSdf decoder_{nullptr};
};
TORCH_MODULE(PointNetwork);

}  // namespace hydrabench

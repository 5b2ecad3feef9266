// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
//
// Includes libtorch: for the sources of core/shape/crisp and of the trainers only.
#pragma once

#include <vector>

#include <torch/torch.h>

namespace hydrabench {

/// Signed-distance decoder of sine layers modulated by a code (FiLM): y = sin(g (W x + b) + h) per
/// layer, then one linear layer (CRISP, Shi et al. 2025, after SIREN and pi-GAN). Negative inside.
class FilmSdfImpl : public torch::nn::Module {
 public:
  struct Options {
    int layers = 4;
    int width = 128;
    /// true: the code gives g - 1, so that a code of zeros changes nothing. false: it gives g, as
    /// in CRISP's own weights.
    bool residual_gain = true;
    double first_range = 5;  ///< weights of the first layer are drawn from +- this
  };
  explicit FilmSdfImpl(const Options& options);

  /// Numbers that modulate the layers: per layer `width` gains, then `width` shifts.
  int modulationSize() const { return 2 * options_.layers * options_.width; }
  /// @param points      [B, N, 3]
  /// @param modulation  [B, modulationSize()]
  /// @return            [B, N]
  torch::Tensor forward(const torch::Tensor& points, const torch::Tensor& modulation);

  /// Names as in CRISP's checkpoints: filmed_sdf.i.0.layer, final_layer.
  const Options& options() const { return options_; }

 private:
  Options options_;
  std::vector<torch::nn::Linear> layers_;
  torch::nn::Linear final_{nullptr};
};
TORCH_MODULE(FilmSdf);

}  // namespace hydrabench

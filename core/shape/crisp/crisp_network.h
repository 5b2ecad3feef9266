// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
//
// Includes libtorch: for the sources of core/shape/crisp and of the trainers only.
#pragma once

#include <array>
#include <vector>

#include <torch/torch.h>

#include "core/shape/crisp/crisp_manifest.h"
#include "core/shape/crisp/dpt_head.h"
#include "core/shape/crisp/film_sdf.h"
#include "core/shape/crisp/vit.h"

namespace hydrabench {

/// CRISP's published network (Shi et al., CVPR 2025): the crop of an object goes in; object
/// coordinates of each pixel and the code of its shape come out. Depth never enters. The defaults
/// are the published sizes, 39.1 M parameters.
///
/// The code is the modulation of the decoder itself: 2560 numbers, not the 256 of the paper.
class CrispNetworkImpl : public torch::nn::Module {
 public:
  struct Options {
    VitImpl::Options vit;
    std::array<int, 4> taps = {2, 5, 8, 11};  ///< blocks of the backbone that are read
    DptOptions head;
    int code_width = 512;  ///< of the hidden layers between backbone and decoder
    FilmSdfImpl::Options decoder = {
        .layers = 5, .width = 256, .residual_gain = false, .first_range = 10};
    int input_side = 420;         ///< [px], a multiple of the patch
    bool train_backbone = false;  ///< upstream never does; no gradient reaches it then
  };
  explicit CrispNetworkImpl(const Options& options);

  struct Output {
    torch::Tensor nocs;        ///< [B, 3, side, side]; meaning: CrispManifest::mode
    torch::Tensor modulation;  ///< [B, decoder.modulationSize()]
  };
  /// @param image  [B, 3, H, W], normalised as the manifest says; resized to the input side
  Output forward(const torch::Tensor& image);

  /// The two halves of forward(): taps of the frozen backbone may be kept between epochs.
  std::vector<VitImpl::Tap> features(const torch::Tensor& image);
  Output predict(const std::vector<VitImpl::Tap>& taps);

  Vit& backbone() { return backbone_; }
  DptHead& head() { return head_; }
  torch::nn::Sequential& codeLayers() { return code_layers_; }
  FilmSdf& decoder() { return decoder_; }
  const Options& options() const { return options_; }

 private:
  Options options_;
  Vit backbone_{nullptr};
  DptHead head_{nullptr};
  torch::nn::Sequential code_layers_;
  FilmSdf decoder_{nullptr};
};
TORCH_MODULE(CrispNetwork);

/// The network of a manifest with preset `full`, in evaluation mode. Throws InputError as
/// loadWeights() does.
CrispNetwork loadCrispNetwork(const CrispManifest& manifest);

}  // namespace hydrabench

// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "core/shape/crisp/full_crisp_model.h"

#include <cstddef>
#include <span>
#include <utility>

#include "core/shape/crisp/crisp_crop.h"
#include "core/shape/crisp/crisp_models.h"
#include "core/shape/crisp/film_field.h"
#include "core/shape/crisp/torch_runtime.h"

namespace hydrabench {
namespace {

constexpr std::size_t kMaxPairs = 1000;  // CRISP

class FullCrispModel : public CrispModel {
 public:
  FullCrispModel(CrispNetwork network, CrispManifest manifest, const std::string& device)
      : network_(std::move(network)), manifest_(std::move(manifest)), device_(device) {
    network_->to(device_);
    network_->eval();
  }

  CrispPrediction predict(const ShapeObservation& view, std::uint64_t seed) const override {
    keepTorchOnThisThread();
    const torch::NoGradGuard no_grad;
    CrispCrop crop = cropOf(view);
    const std::int64_t side = crop.side;
    const torch::Tensor image = torch::from_blob(crop.color.data(), {1, 3, side, side});
    // The module is shared, but in evaluation mode nothing in it changes.
    const CrispNetworkImpl::Output output = network_.ptr()->forward(image.to(device_));
    const torch::Tensor nocs = output.nocs.to(torch::kCPU).contiguous();
    NocsPairs pairs = gatherNocsPairs(
        crop, std::span(nocs.data_ptr<float>(), static_cast<std::size_t>(nocs.numel())), manifest_,
        kMaxPairs, seed);
    return {std::move(pairs.nocs), std::move(pairs.points),
            makeFilmField(*network_.ptr()->decoder(), output.modulation)};
  }
  NocsFreedom freedom() const override {
    return manifest_.isMetric() ? NocsFreedom::kRigid : NocsFreedom::kSimilarity;
  }
  double cubeHalfSide() const override { return manifest_.cube_half_side; }
  bool needsColor() const override { return true; }

 private:
  CrispCrop cropOf(const ShapeObservation& view) const {
    const int side = network_->options().input_side;
    if (manifest_.crop == "none") {
      const PixelBox whole{0, 0, view.mask.width() - 1, view.mask.height() - 1};
      return makeCrispCrop(view, whole, manifest_, side);
    }
    return makeCrispCrop(view, manifest_, side).value();
  }

  CrispNetwork network_;
  CrispManifest manifest_;
  torch::Device device_;
};

}  // namespace

std::unique_ptr<const CrispModel> makeFullCrisp(CrispNetwork network, const CrispManifest& manifest,
                                                const std::string& device) {
  return std::make_unique<FullCrispModel>(std::move(network), manifest, device);
}

std::unique_ptr<const CrispModel> loadFullCrisp(const CrispManifest& manifest,
                                                const std::string& device) {
  return makeFullCrisp(loadCrispNetwork(manifest), manifest, device);
}

std::unique_ptr<const CrispModel> randomFullCrisp(std::uint64_t seed) {
  torch::manual_seed(seed);
  CrispManifest manifest;
  manifest.mode = "normalised";
  return makeFullCrisp(CrispNetwork(CrispNetworkImpl::Options{}), manifest, "cpu");
}

}  // namespace hydrabench

// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "core/shape/latent_flow/torch_latent_flow_model.h"

#include <algorithm>
#include <utility>

#include "core/shape/crisp/torch_runtime.h"
#include "core/shape/crisp/torch_weights.h"
#include "core/shape/latent_flow/flow_sampler.h"
#include "core/shape/latent_flow/pose_tokens.h"

namespace hydrabench {
namespace {

class TorchLatentFlowModel : public LatentFlowModel {
 public:
  TorchLatentFlowModel(LatentFlowNetwork network, const std::string& device)
      : network_(std::move(network)), device_(device) {
    network_->to(device_);
    network_->eval();
  }

  LocalFrame drawPose(const PointInput& view, int samples, int steps,
                      std::uint64_t seed) const override {
    keepTorchOnThisThread();
    const torch::NoGradGuard no_grad;
    // The modules are shared, but in evaluation mode nothing in them changes.
    PoseFlowImpl& flow = *network_.ptr()->pose;
    PointBatch batch = makePointBatch({&view, 1});
    for (torch::Tensor* tensor : {&batch.points, &batch.patches, &batch.globals}) {
      *tensor = tensor->to(device_);
    }
    const torch::Tensor context = flow.view(batch);
    const Velocity velocity = [&](const torch::Tensor& x, double t) {
      return flow.forward(x, torch::full({samples}, t, x.options()), context);
    };
    const torch::Tensor noise =
        normalNoise({samples, PoseTokens::kTokens, PoseTokens::kWidth}, seed).to(device_);
    const torch::Tensor drawn =
        followFlow(velocity, noise, steps).to(torch::kCPU).reshape({samples, -1}).contiguous();
    const float* best = drawn.data_ptr<float>() + medoid(drawn) * PoseTokens::kNumbers;
    PoseTokens tokens;
    std::copy_n(best, PoseTokens::kNumbers, tokens.numbers.begin());
    return fromPoseTokens(tokens, view.frame);
  }

  SdfField drawShape(const ViewGrid& view, double guidance, int steps,
                     std::uint64_t seed) const override {
    keepTorchOnThisThread();
    const torch::NoGradGuard no_grad;
    LatentFlowNetworkImpl& network = *network_.ptr();
    ShapeFlowImpl& flow = *network.shape;
    // With the condition and without it, side by side.
    const std::int64_t both = guidance == 1 ? 1 : 2;
    const torch::Tensor cells = torch::tensor(view.cells)
                                    .view({1, kShapeTokens, ViewGrid::kBlockFeatures})
                                    .expand({both, -1, -1})
                                    .to(device_);
    const torch::Tensor globals =
        torch::tensor(std::vector<float>(view.globals.begin(), view.globals.end()))
            .view({1, ViewGrid::kGlobals})
            .expand({both, -1})
            .to(device_);
    const torch::Tensor given = torch::tensor({1.0f, 0.0f}).slice(0, 0, both).to(device_);
    const Velocity velocity = [&](const torch::Tensor& x, double t) {
      const torch::Tensor v = flow.forward(
          x.expand({both, -1, -1}), torch::full({both}, t, x.options()), cells, globals, given);
      return both == 1 ? v : guidedVelocity(v.slice(0, 0, 1), v.slice(0, 1, 2), guidance);
    };
    const torch::Tensor noise =
        normalNoise({1, kShapeTokens, flow.options().latent}, seed).to(device_);
    const torch::Tensor latent = followFlow(velocity, noise, steps);
    ShapeAutoencoder autoencoder = network.autoencoder;
    return makeLatentField(autoencoder, autoencoder->decode(autoencoder->denormalize(latent)));
  }

 private:
  LatentFlowNetwork network_;
  torch::Device device_;
};

}  // namespace

std::int64_t medoid(const torch::Tensor& rows) {
  return (rows.unsqueeze(0) - rows.unsqueeze(1)).norm(2, 2).sum(1).argmin().item<std::int64_t>();
}

std::unique_ptr<const LatentFlowModel> makeLatentFlowModel(LatentFlowNetwork network,
                                                           const std::string& device) {
  return std::make_unique<TorchLatentFlowModel>(std::move(network), device);
}

std::unique_ptr<const LatentFlowModel> loadLatentFlowModel(const std::filesystem::path& manifest,
                                                           const std::string& device) {
  requireTorchDevice(device);
  std::error_code error;
  const bool is_folder = std::filesystem::is_directory(manifest, error);
  const LatentFlowManifest read =
      readLatentFlowManifest(is_folder ? manifest / "manifest.yaml" : manifest);
  LatentFlowNetwork network(read.network);
  loadWeights(*network, read.weights);
  return makeLatentFlowModel(std::move(network), device);
}

}  // namespace hydrabench

// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "core/shape/crisp/small_crisp_model.h"

#include <utility>

#include "core/shape/crisp/crisp_models.h"
#include "core/shape/crisp/film_field.h"
#include "core/shape/crisp/object_points.h"
#include "core/shape/crisp/point_input.h"
#include "core/shape/crisp/torch_runtime.h"
#include "core/shape/crisp/torch_weights.h"
#include "core/types/random.h"

namespace hydrabench {
namespace {

/// Deviation of the codes of shapes: a scale for steps, nothing depends on it exactly.
constexpr double kCodeSpread = 0.1;

class SmallCrispModel : public CrispModel {
 public:
  SmallCrispModel(PointNetwork network, const CrispManifest& manifest, const std::string& device)
      : network_(std::move(network)), manifest_(manifest), device_(device) {
    network_->to(device_);
    network_->eval();
  }

  CrispPrediction predict(const ShapeObservation& view, std::uint64_t seed) const override {
    keepTorchOnThisThread();
    const torch::NoGradGuard no_grad;
    const ObjectPoints points = gatherObjectPoints(view, {}, hashSeed(seed, 0));
    // There are points: the estimator refuses views with fewer than the input needs.
    const PointInput input = makePointInput(points, hashSeed(seed, 1)).value();
    PointBatch batch = makePointBatch({&input, 1});
    for (torch::Tensor* tensor :
         {&batch.points, &batch.patches, &batch.near, &batch.near_weights, &batch.globals}) {
      *tensor = tensor->to(device_);
    }
    // The module is shared, but in evaluation mode nothing in it changes.
    PointNetworkImpl& network = *network_.ptr();
    const PointNetworkImpl::Output output = network.forward(batch);
    const torch::Tensor nocs = output.nocs.to(torch::kCPU).contiguous();
    const float* value = nocs.data_ptr<float>();
    const Eigen::Matrix3d R_camera_level = view.T_world_camera.linear().transpose();
    CrispPrediction prediction;
    for (const std::uint32_t source : input.source) {
      prediction.nocs.emplace_back(value[0], value[1], value[2]);
      prediction.points.push_back(R_camera_level * points.object[source].cast<double>());
      value += 3;
    }
    prediction.field = fieldOf(output.code);
    const torch::Tensor code = output.code.to(torch::kCPU).contiguous();
    prediction.code.assign(code.data_ptr<float>(), code.data_ptr<float>() + code.numel());
    return prediction;
  }
  void refine(const ShapeRefinementConfig& config, const ShapeObservation& best,
              std::span<const ShapeObservation> others, std::uint64_t seed,
              Similarity& camera_from_object, CrispPrediction& prediction) const override {
    const LatentField field = [&](const torch::Tensor& points, const torch::Tensor& code) {
      return network_.ptr()->sdf(points.to(device_), code.to(device_)).to(torch::kCPU);
    };
    RefinedShape refined = refineShape(field, {camera_from_object, prediction.code}, kCodeSpread,
                                       best, others, config, seed);
    camera_from_object = refined.camera_from_object;
    prediction.code = std::move(refined.code);
    const torch::NoGradGuard no_grad;
    prediction.field = fieldOf(
        torch::from_blob(prediction.code.data(), {1, static_cast<int64_t>(prediction.code.size())})
            .to(device_));
  }
  NocsFreedom freedom() const override { return NocsFreedom::kUpright; }
  double cubeHalfSide() const override { return manifest_.cube_half_side; }
  bool needsColor() const override { return false; }

 private:
  SdfField fieldOf(const torch::Tensor& code) const {
    PointNetworkImpl& network = *network_.ptr();
    return makeFilmField(*network.decoder(), network.modulation()(code));
  }

  PointNetwork network_;
  CrispManifest manifest_;
  torch::Device device_;
};

}  // namespace

PointNetwork loadPointNetwork(const CrispManifest& manifest) {
  PointNetworkImpl::Options options;
  options.dim = manifest.encoder_dim;
  options.depth = manifest.encoder_depth;
  options.heads = manifest.encoder_heads;
  options.decoder.layers = manifest.sdf_layers;
  options.decoder.width = manifest.sdf_width;
  PointNetwork network(options);
  loadWeights(*network, manifest.weights);
  return network;
}

std::unique_ptr<const CrispModel> makeSmallCrisp(PointNetwork network,
                                                 const CrispManifest& manifest,
                                                 const std::string& device) {
  return std::make_unique<SmallCrispModel>(std::move(network), manifest, device);
}

std::unique_ptr<const CrispModel> loadSmallCrisp(const CrispManifest& manifest,
                                                 const std::string& device) {
  return makeSmallCrisp(loadPointNetwork(manifest), manifest, device);
}

}  // namespace hydrabench

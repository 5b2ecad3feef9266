// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/training/latent_flow_losses.h"

#include <cmath>

#include "core/shape/latent_flow/flow_sampler.h"
#include "eval/training/distance_loss.h"

namespace hydrabench {
namespace {

torch::Tensor stackFloats(const std::vector<const float*>& rows, std::int64_t width) {
  torch::Tensor result = torch::empty({static_cast<std::int64_t>(rows.size()), width});
  float* out = result.data_ptr<float>();
  for (const float* row : rows) out = std::copy_n(row, width, out);
  return result;
}

PhaseLoss flowLoss(const torch::Tensor& predicted, const FlowTarget& target) {
  PhaseLoss loss;
  loss.total = (predicted - target.velocity).square().mean();
  loss.numbers["flow"] = loss.total.item<double>();
  return loss;
}

}  // namespace

torch::Tensor makeGrids(const std::vector<const ShapeGrid*>& grids) {
  torch::Tensor result =
      torch::empty({static_cast<std::int64_t>(grids.size()), kGridSide * kGridSide * kGridSide});
  float* out = result.data_ptr<float>();
  for (const ShapeGrid* grid : grids) {
    for (const std::int8_t value : grid->values) *out++ = static_cast<float>(value) / 127;
  }
  return result;
}

PhaseLoss autoencoderLoss(const LatentFlowTrainingConfig::Autoencoder& config,
                          ShapeAutoencoder& network, const std::vector<FieldSample>& samples,
                          Random random) {
  const auto batch = static_cast<std::int64_t>(samples.size());
  std::vector<const ShapeGrid*> grids;
  std::vector<const float*> points;
  std::vector<const float*> distances;
  for (const FieldSample& sample : samples) {
    grids.push_back(sample.grid);
    points.push_back(sample.points.front().data());
    distances.push_back(sample.distances.data());
  }
  const auto count = static_cast<std::int64_t>(samples.front().points.size());
  const torch::Tensor latent = network->encode(makeGrids(grids));
  const torch::Tensor noise = normalNoise(latent.sizes().vec(), random.bits());
  const torch::Tensor features = network->decode(latent + config.latent_noise * noise);
  const torch::Tensor predicted =
      network->distance(features, stackFloats(points, 3 * count).view({batch, count, 3}));
  const torch::Tensor error = distanceLoss(predicted, stackFloats(distances, count), kTruncation);
  PhaseLoss loss;
  loss.total = error / kTruncation + config.latent_penalty * latent.square().mean();
  loss.numbers["sdf_l1"] = error.item<double>();
  return loss;
}

FlowTarget drawFlowTarget(const torch::Tensor& data, Random random) {
  const std::int64_t batch = data.size(0);
  FlowTarget target;
  target.time = torch::sigmoid(normalNoise({batch}, random.bits()));
  const torch::Tensor noise = normalNoise(data.sizes().vec(), random.bits());
  std::vector<std::int64_t> shape(static_cast<std::size_t>(data.dim()), 1);
  shape[0] = batch;
  const torch::Tensor t = target.time.view(shape);
  target.x = (1 - t) * noise + t * data;
  target.velocity = data - noise;
  return target;
}

PhaseLoss poseFlowLoss(PoseFlow& network, const std::vector<PoseSample>& samples, Random random) {
  std::vector<PointInput> inputs;
  std::vector<const float*> poses;
  for (const PoseSample& sample : samples) {
    inputs.push_back(sample.input);
    poses.push_back(sample.pose.numbers.data());
  }
  // One view serves for several times: the encoder is most of the work.
  constexpr std::int64_t kTimes = 8;
  const torch::Tensor view = network->view(makePointBatch(inputs));
  const torch::Tensor pose = stackFloats(poses, PoseTokens::kNumbers)
                                 .view({-1, PoseTokens::kTokens, PoseTokens::kWidth})
                                 .repeat_interleave(kTimes, 0);
  const FlowTarget target = drawFlowTarget(pose, random);
  return flowLoss(network->forward(target.x, target.time, view), target);
}

PhaseLoss shapeFlowLoss(ShapeFlow& network, const std::vector<LatentSample>& samples,
                        const torch::Tensor& latents, double dropout, Random random) {
  const auto batch = static_cast<std::int64_t>(samples.size());
  std::vector<const float*> cells;
  std::vector<const float*> globals;
  std::vector<std::int64_t> rows;
  std::vector<float> given;
  for (const LatentSample& sample : samples) {
    cells.push_back(sample.view.cells.data());
    globals.push_back(sample.view.globals.data());
    rows.push_back(static_cast<std::int64_t>(sample.latent));
    given.push_back(random.chance(dropout) ? 0.0f : 1.0f);
  }
  const FlowTarget target = drawFlowTarget(latents.index_select(0, torch::tensor(rows)), random);
  const torch::Tensor condition = stackFloats(cells, kShapeTokens * ViewGrid::kBlockFeatures)
                                      .view({batch, kShapeTokens, ViewGrid::kBlockFeatures});
  return flowLoss(network->forward(target.x, target.time, condition,
                                   stackFloats(globals, ViewGrid::kGlobals), torch::tensor(given)),
                  target);
}

}  // namespace hydrabench

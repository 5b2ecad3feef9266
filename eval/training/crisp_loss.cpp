// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include <algorithm>

#include "eval/training/crisp_trainer.h"
#include "eval/training/distance_loss.h"

namespace hydrabench {
namespace {

constexpr double kSmooth = 0.1;  // object coordinates: where the loss turns from squared to linear

torch::Tensor smoothL1(const torch::Tensor& difference) {
  const torch::Tensor d = difference.abs();
  return torch::where(d <= kSmooth, d.square() / (2 * kSmooth), d - kSmooth / 2);
}

}  // namespace

PointNetworkImpl::Options networkOptions(const CrispTrainingConfig& config) {
  PointNetworkImpl::Options options;
  options.dim = config.network.dim;
  options.depth = config.network.depth;
  options.heads = config.network.heads;
  options.decoder.layers = config.network.decoder_layers;
  options.decoder.width = config.network.decoder_width;
  return options;
}

TrainingBatch makeTrainingBatch(std::span<const TrainingSample> samples, const ShapeCodes& codes) {
  std::vector<PointInput> inputs;
  for (const TrainingSample& sample : samples) inputs.push_back(sample.input);
  TrainingBatch batch;
  batch.input = makePointBatch(inputs);
  const auto size = static_cast<std::int64_t>(samples.size());
  const auto count = static_cast<std::int64_t>(samples.front().distances.size());
  constexpr int kPoses = TrainingSample::kPoses;
  batch.nocs = torch::empty({size, kPoses, PointInput::kObjectPoints, 3});
  batch.weights = torch::empty({size, PointInput::kObjectPoints});
  batch.direct = torch::empty({size, kPoses, 6});
  batch.points = torch::empty({size, count, 3});
  batch.distances = torch::empty({size, count});
  batch.code_rows = torch::full({size}, -1, torch::kInt64);
  float* nocs = batch.nocs.data_ptr<float>();
  float* weights = batch.weights.data_ptr<float>();
  float* direct = batch.direct.data_ptr<float>();
  float* points = batch.points.data_ptr<float>();
  float* distances = batch.distances.data_ptr<float>();
  std::int64_t* rows = batch.code_rows.data_ptr<std::int64_t>();
  for (const TrainingSample& sample : samples) {
    for (int k = 0; k < kPoses; ++k) {
      nocs = std::copy(sample.nocs[k].begin(), sample.nocs[k].end(), nocs);
      direct = std::copy(sample.direct[k].begin(), sample.direct[k].end(), direct);
    }
    weights = std::copy(sample.weights.begin(), sample.weights.end(), weights);
    points = std::copy(sample.points.begin(), sample.points.end(), points);
    distances = std::copy(sample.distances.begin(), sample.distances.end(), distances);
    const auto found = codes.rows.find(sample.shape);
    *rows++ = found == codes.rows.end() ? -1 : found->second;
    batch.classes.push_back(sample.class_name);
  }
  return batch;
}

namespace {

/// [B, 1]
torch::Tensor quantiles(const CrispTrainingConfig& config, const TrainingBatch& batch) {
  std::vector<double> values;
  for (const std::string& name : batch.classes) {
    const auto found = config.sdf_quantiles.find(name);
    values.push_back(found == config.sdf_quantiles.end() ? 0.5 : found->second);
  }
  return torch::tensor(values, torch::kFloat32).unsqueeze(1);
}

}  // namespace

CrispLoss crispLoss(const CrispTrainingConfig& config, PointNetwork network,
                    const TrainingBatch& batch, const ShapeCodes& codes) {
  const PointNetworkImpl::Output output = network->forward(batch.input);
  const CrispTrainingConfig::Joint& phase = config.joint;

  // Per pose, the smaller one counts: of yaws under which the object looks the same any is right.
  const torch::Tensor weights = batch.weights.unsqueeze(1);  // [B, 1, P]
  const torch::Tensor count = weights.sum(-1).clamp_min(1);  // [B, 1]
  const torch::Tensor difference = output.nocs.unsqueeze(1) - batch.nocs;
  const torch::Tensor nocs = (smoothL1(difference).sum(-1) * weights).sum(-1) / count;
  const torch::Tensor error = (difference.norm(2, -1) * weights).sum(-1) / count;
  const torch::Tensor direct_difference = output.direct.unsqueeze(1) - batch.direct;
  const torch::Tensor direct = smoothL1(direct_difference.narrow(2, 0, 4)).sum(-1) +
                               0.5 * direct_difference.narrow(2, 4, 2).square().sum(-1);
  const torch::Tensor poses = phase.nocs_weight * nocs + phase.direct_weight * direct;
  const auto [pose_loss, pose] = poses.min(1);
  const torch::Tensor sdf = distanceLoss(network->sdf(batch.points, output.code), batch.distances,
                                         config.target_clamp, quantiles(config, batch));
  CrispLoss loss;
  loss.total = pose_loss.mean() + phase.sdf_weight * sdf;
  if (codes.codes.defined()) {
    const torch::Tensor known = (batch.code_rows >= 0).to(torch::kFloat32);
    const torch::Tensor target = codes.codes.index_select(0, batch.code_rows.clamp_min(0));
    // In units of the spread of the codes.
    const torch::Tensor code = ((output.code - target).square().mean(1) * known).sum() /
                               known.sum().clamp_min(1) / codes.variance;
    loss.total = loss.total + phase.code_weight * code;
    loss.code = code.item<double>();
  }
  const torch::Tensor chosen = pose.unsqueeze(1);
  loss.nocs = nocs.gather(1, chosen).mean().item<double>();
  loss.nocs_error = error.gather(1, chosen).mean().item<double>();
  loss.sdf = sdf.item<double>();
  loss.direct = direct.gather(1, chosen).mean().item<double>();
  return loss;
}

}  // namespace hydrabench

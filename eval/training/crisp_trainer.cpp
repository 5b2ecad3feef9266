// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/training/crisp_trainer.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

#include <fmt/format.h>

#include "core/parallel/parallel_for.h"
#include "core/shape/crisp/torch_runtime.h"
#include "eval/training/checkpoint.h"
#include "eval/training/half_precision.h"
#include "eval/training/loss_file.h"
#include "eval/training/sharded.h"

namespace hydrabench {
namespace {

using Joint = CrispTrainingConfig::Joint;

/// Linear warm-up, then a cosine down to a fiftieth.
double rateAt(int step, const Joint& phase) {
  const double warm = std::min(1.0, (step + 1.0) / phase.warmup_steps);
  const double share = static_cast<double>(step) / phase.steps;
  return warm * (0.02 + 0.98 * 0.5 * (1 + std::cos(std::numbers::pi * share)));
}

/// First world of the window at a step: it moves on evenly, from the first worlds to the last.
std::uint64_t windowBegin(int step, const Joint& phase) {
  const int moves = std::max(0, phase.worlds - phase.window);
  return static_cast<std::uint64_t>(static_cast<std::int64_t>(step) * (moves + 1) / phase.steps);
}

/// Decoder and encoder learn at different rates; norms, biases and the like do not decay.
torch::optim::AdamW makeOptimizer(PointNetwork network, const Joint& phase) {
  std::vector<torch::Tensor> groups[4];
  for (const auto& item : network->named_parameters()) {
    const bool decoder =
        item.key().rfind("decoder", 0) == 0 || item.key().rfind("modulation", 0) == 0;
    const bool decays = item.value().dim() > 1 && !decoder;
    groups[(decoder ? 2 : 0) + (decays ? 1 : 0)].push_back(item.value());
  }
  std::vector<torch::optim::OptimizerParamGroup> list;
  for (int i = 0; i < 4; ++i) {
    auto options = std::make_unique<torch::optim::AdamWOptions>(phase.learning_rate);
    options->weight_decay(i % 2 ? phase.weight_decay : 0);
    list.emplace_back(groups[i], std::move(options));
  }
  return torch::optim::AdamW(list, torch::optim::AdamWOptions(phase.learning_rate));
}

void setRate(torch::optim::Optimizer& optimizer, double rate, double decoder_share) {
  for (std::size_t i = 0; i < optimizer.param_groups().size(); ++i) {
    static_cast<torch::optim::AdamWOptions&>(optimizer.param_groups()[i].options())
        .lr(i < 2 ? rate : rate * decoder_share);
  }
}

/// Exponential average of the weights.
class Average {
 public:
  explicit Average(PointNetwork network, const PointNetworkImpl::Options& options)
      : network_(network), average(options) {
    follow(1);
  }
  void follow(double share) {
    const torch::NoGradGuard no_grad;
    const std::vector<torch::Tensor> from = network_->parameters();
    std::vector<torch::Tensor> to = average->parameters();
    for (std::size_t k = 0; k < from.size(); ++k) to[k].lerp_(from[k], share);
  }

 private:
  PointNetwork network_;

 public:
  PointNetwork average;
};

CrispLoss validate(const CrispTrainingConfig& config, PointNetwork network,
                   const TrainingPool& pool) {
  const torch::NoGradGuard no_grad;
  constexpr int kBatches = 8;
  CrispLoss mean;
  for (int i = 0; i < kBatches; ++i) {
    std::vector<TrainingSample> samples;
    for (int k = 0; k < 32; ++k) {
      samples.push_back(
          pool.draw(config.class_weights, config.joint.sdf_points, false,
                    Random(config.seed, 14).fork(static_cast<std::uint64_t>(100 * i + k))));
    }
    const CrispLoss loss = crispLoss(config, network, makeTrainingBatch(samples, {}), {});
    mean.nocs_error += loss.nocs_error / kBatches;
    mean.sdf += loss.sdf / kBatches;
    mean.direct += loss.direct / kBatches;
  }
  return mean;
}

/// All that the steps need.
class JointTraining {
 public:
  JointTraining(const CrispTrainingConfig& config, const std::filesystem::path& out,
                PointNetwork network, ShapeCodes codes)
      : config_(config),
        network_(network),
        codes_(std::move(codes)),
        pool_(config.worlds, InstanceSplit::kTraining, out / "worlds"),
        held_out_(config.worlds, InstanceSplit::kValidation, out / "worlds"),
        optimizer_(makeOptimizer(network, config.joint)),
        average_(network, networkOptions(config)),
        half_(wantsHalfPrecision(config.precision)),
        state_(out / "network.checkpoint",
               {{"step", [this] { return torch::tensor(step_); },
                 [this](const torch::Tensor& t) { step_ = t.item<int>(); }}}) {
    held_out_.load(0, static_cast<std::uint64_t>(config.validation_worlds));
    state_.add("network", network_.ptr());
    state_.add("average", average_.average.ptr());
    state_.add("optimizer", optimizer_);
    state_.load();
    file_.emplace(out / "loss.csv", "network", step_);
    // After loading: it gives the network new memory, which the shards share.
    shards_.emplace(network_, config.shards, [&] { return PointNetwork(networkOptions(config)); });
  }

  bool run(const TrainingProgress& progress, const StopRequest& stop) {
    for (; step_ < config_.joint.steps; ++step_) {
      if (stop()) {
        state_.save();
        return false;
      }
      const CrispLoss loss = step();
      std::map<std::string, double> numbers = {
          {"nocs", loss.nocs_error}, {"sdf", loss.sdf}, {"code", loss.code}};
      const int done = step_ + 1;
      if (done % kLossEvery == 0 || done == config_.joint.steps) report(loss, done);
      progress("network", done, config_.joint.steps, numbers);
      if (done % config_.checkpoint_every == 0 || done == config_.joint.steps) {
        ++step_;
        state_.save();
        --step_;
      }
    }
    return true;
  }
  void copyAverage() {
    const torch::NoGradGuard no_grad;
    const std::vector<torch::Tensor> from = average_.average->parameters();
    std::vector<torch::Tensor> to = network_->parameters();
    for (std::size_t k = 0; k < from.size(); ++k) to[k].copy_(from[k]);
  }

 private:
  CrispLoss step() {
    const Joint& phase = config_.joint;
    const std::uint64_t begin = windowBegin(step_, phase);
    pool_.load(begin, begin + static_cast<std::uint64_t>(std::min(phase.window, phase.worlds)));
    const Random random = Random(config_.seed, 13).fork(static_cast<std::uint64_t>(step_));
    std::vector<CrispLoss> losses(shards_->size());
    parallelFor(shards_->size(), [&](std::size_t k) {
      keepTorchOnThisThread();
      std::vector<TrainingSample> samples;
      for (int i = 0; i < phase.batch / static_cast<int>(shards_->size()); ++i) {
        samples.push_back(pool_.draw(config_.class_weights, phase.sdf_points, true,
                                     random.fork(k).fork(static_cast<std::uint64_t>(i))));
      }
      {
        const Autocast autocast(half_);
        losses[k] = crispLoss(config_, (*shards_)[k], makeTrainingBatch(samples, codes_), codes_);
      }
      losses[k].total.backward();
      losses[k].total = torch::Tensor();
    });
    shards_->collectGradients();
    torch::nn::utils::clip_grad_norm_(network_->parameters(), 2.0);
    setRate(optimizer_, phase.learning_rate * rateAt(step_, phase),
            phase.decoder_learning_rate_share);
    optimizer_.step();
    const double decay = std::min(phase.average_decay, (1.0 + step_) / (10.0 + step_));
    average_.follow(1 - decay);
    CrispLoss mean;
    for (const CrispLoss& loss : losses) {
      const double share = 1 / static_cast<double>(losses.size());
      mean.nocs_error += share * loss.nocs_error;
      mean.sdf += share * loss.sdf;
      mean.direct += share * loss.direct;
      mean.code += share * loss.code;
    }
    return mean;
  }

  void report(const CrispLoss& loss, int done) {
    const Joint& phase = config_.joint;
    std::map<std::string, double> numbers = {
        {"samples", static_cast<double>(done) * phase.batch},
        {"learning_rate", phase.learning_rate * rateAt(step_, phase)},
        {"nocs_error", loss.nocs_error},
        {"sdf_l1", loss.sdf},
        {"direct", loss.direct},
        {"code", loss.code}};
    if (done % config_.validation_every == 0 || done == phase.steps) {
      const CrispLoss held_out = validate(config_, average_.average, held_out_);
      numbers["val_nocs_error"] = held_out.nocs_error;
      numbers["val_sdf_l1"] = held_out.sdf;
      numbers["val_direct"] = held_out.direct;
    }
    file_->line(done, numbers);
  }

  const CrispTrainingConfig& config_;
  PointNetwork network_;
  ShapeCodes codes_;
  TrainingPool pool_;
  TrainingPool held_out_;
  torch::optim::AdamW optimizer_;
  Average average_;
  std::optional<Shards<PointNetwork>> shards_;
  bool half_;
  std::optional<LossFile> file_;
  int step_ = 0;
  Checkpoint state_;
};

}  // namespace

TrainingState trainCrisp(const CrispTrainingConfig& config, const std::filesystem::path& out,
                         PointNetwork network, const TrainingProgress& progress,
                         const StopRequest& stop) {
  std::filesystem::create_directories(out);
  std::optional<ShapeCodes> codes;
  {
    TrainingPool pool(config.worlds, InstanceSplit::kTraining, out / "worlds");
    for (int i = 1; i <= config.decoder.worlds; ++i) {
      if (stop()) return TrainingState::kNoNetworkYet;
      pool.load(0, static_cast<std::uint64_t>(i));
      progress("worlds", i, config.decoder.worlds, {});
    }
    codes = trainShapeDecoder(config, pool, network, out, progress, stop);
  }
  if (!codes) return TrainingState::kNoNetworkYet;
  JointTraining joint(config, out, network, *std::move(codes));
  const bool finished = joint.run(progress, stop);
  joint.copyAverage();
  return finished ? TrainingState::kFinished : TrainingState::kStopped;
}

}  // namespace hydrabench

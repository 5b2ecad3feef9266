// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
//
// Includes libtorch: for the sources of the trainers only.
#pragma once

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <functional>
#include <map>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include <torch/torch.h>

#include "core/parallel/parallel_for.h"
#include "core/shape/crisp/torch_runtime.h"
#include "core/types/random.h"
#include "eval/training/checkpoint.h"
#include "eval/training/crisp_training.h"
#include "eval/training/half_precision.h"
#include "eval/training/latent_flow_training_config.h"
#include "eval/training/loss_file.h"
#include "eval/training/sharded.h"

namespace hydrabench {

/// A loss of one part of a batch, and numbers to report: columns of loss.csv.
struct PhaseLoss {
  torch::Tensor total;
  std::map<std::string, double> numbers;
};

/// Trains one module: AdamW, warm-up and cosine, gradients of shards added up in fixed order,
/// exponential average of the weights. Goes on from the checkpoint out/NAME.checkpoint.
template <typename Module>
class FlowPhase {
 public:
  struct Parts {
    std::string name;
    std::function<Module()> make;  ///< a module of the same structure
    /// @param count  samples to draw; may run on several threads, each with a module of its own
    std::function<PhaseLoss(Module& module, int count, Random random)> loss;
    std::function<std::map<std::string, double>(Module& averaged)> validate;
  };
  FlowPhase(const LatentFlowTrainingConfig& config, const FlowPhaseConfig& phase, Module module,
            Parts parts, const std::filesystem::path& out)
      : config_(config),
        phase_(phase),
        parts_(std::move(parts)),
        module_(module),
        average_(parts_.make()),
        optimizer_(makeOptimizer()),
        half_(wantsHalfPrecision(config.precision)),
        state_(out / (parts_.name + ".checkpoint"),
               {{"step", [this] { return torch::tensor(step_); },
                 [this](const torch::Tensor& t) { step_ = t.item<int>(); }}}) {
    follow(1);
    state_.add("module", module_.ptr());
    state_.add("average", average_.ptr());
    state_.add("optimizer", optimizer_);
    state_.load();
    file_.emplace(out / "loss.csv", parts_.name, step_);
    // After loading: it gives the module new memory, which the shards share.
    shards_.emplace(module_, config.shards, parts_.make);
  }

  /// @return false if asked to stop. Either way the module ends with the averaged weights.
  bool run(const TrainingProgress& progress, const StopRequest& stop) {
    bool finished = true;
    while (step_ < phase_.steps) {
      if (stop()) {
        state_.save();
        finished = false;
        break;
      }
      const std::map<std::string, double> numbers = step();
      ++step_;
      if (step_ % kLossEvery == 0 || step_ == phase_.steps) report(numbers);
      progress(parts_.name, step_, phase_.steps, numbers);
      if (step_ % config_.checkpoint_every == 0 || step_ == phase_.steps) state_.save();
    }
    copy(average_, module_);
    return finished;
  }

 private:
  double rate() const {  // linear warm-up, then a cosine down to a fiftieth
    const double warm = std::min(1.0, (step_ + 1.0) / phase_.warmup_steps);
    const double share = static_cast<double>(step_) / phase_.steps;
    return phase_.learning_rate * warm *
           (0.02 + 0.98 * 0.5 * (1 + std::cos(std::numbers::pi * share)));
  }

  torch::optim::AdamW makeOptimizer() {  // norms, biases and the like do not decay
    std::vector<torch::Tensor> groups[2];
    for (const torch::Tensor& value : module_->parameters()) {
      groups[value.dim() == 2 ? 1 : 0].push_back(value);
    }
    std::vector<torch::optim::OptimizerParamGroup> list;
    for (int i = 0; i < 2; ++i) {
      auto options = std::make_unique<torch::optim::AdamWOptions>(phase_.learning_rate);
      options->weight_decay(i * phase_.weight_decay).betas({0.9, 0.98});
      list.emplace_back(groups[i], std::move(options));
    }
    return torch::optim::AdamW(list, torch::optim::AdamWOptions(phase_.learning_rate));
  }

  static void copy(Module& from, Module& to) {
    const torch::NoGradGuard no_grad;
    const std::vector<torch::Tensor> values = from->parameters();
    std::vector<torch::Tensor> target = to->parameters();
    for (std::size_t k = 0; k < values.size(); ++k) target[k].copy_(values[k]);
  }
  void follow(double share) {
    const torch::NoGradGuard no_grad;
    const std::vector<torch::Tensor> from = module_->parameters();
    std::vector<torch::Tensor> to = average_->parameters();
    for (std::size_t k = 0; k < from.size(); ++k) to[k].lerp_(from[k], share);
  }

  std::map<std::string, double> step() {
    const Random random = Random(config_.seed, 21).fork(static_cast<std::uint64_t>(step_));
    std::vector<PhaseLoss> losses(shards_->size());
    parallelFor(shards_->size(), [&](std::size_t k) {
      keepTorchOnThisThread();
      {
        const Autocast autocast(half_);
        losses[k] = parts_.loss((*shards_)[k], phase_.batch / static_cast<int>(shards_->size()),
                                random.fork(k));
      }
      losses[k].total.backward();
      losses[k].total = torch::Tensor();
    });
    shards_->collectGradients();
    torch::nn::utils::clip_grad_norm_(module_->parameters(), 1.0);
    for (auto& group : optimizer_.param_groups()) {
      static_cast<torch::optim::AdamWOptions&>(group.options()).lr(rate());
    }
    optimizer_.step();
    follow(1 - std::min(config_.average_decay, (1.0 + step_) / (10.0 + step_)));
    std::map<std::string, double> mean;
    for (const PhaseLoss& loss : losses) {
      for (const auto& [name, value] : loss.numbers) {
        mean[name] += value / static_cast<double>(losses.size());
      }
    }
    return mean;
  }

  void report(std::map<std::string, double> numbers) {
    numbers["samples"] = static_cast<double>(step_) * phase_.batch;
    numbers["learning_rate"] = rate();
    if (step_ % config_.validation_every == 0 || step_ == phase_.steps) {
      const torch::NoGradGuard no_grad;
      numbers.merge(parts_.validate(average_));
    }
    file_->line(step_, numbers);
  }

  const LatentFlowTrainingConfig& config_;
  FlowPhaseConfig phase_;
  Parts parts_;
  Module module_;
  Module average_;
  torch::optim::AdamW optimizer_;
  bool half_;
  int step_ = 0;
  Checkpoint state_;
  std::optional<LossFile> file_;
  std::optional<Shards<Module>> shards_;
};

}  // namespace hydrabench

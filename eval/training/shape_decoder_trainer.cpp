// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/training/shape_decoder_trainer.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "core/parallel/parallel_for.h"
#include "core/shape/crisp/torch_runtime.h"
#include "eval/training/checkpoint.h"
#include "eval/training/distance_loss.h"
#include "eval/training/half_precision.h"
#include "eval/training/loss_file.h"
#include "eval/training/sharded.h"

namespace hydrabench {
namespace {

/// The part of the network that is trained here.
class DecoderImpl : public torch::nn::Module {
 public:
  explicit DecoderImpl(PointNetwork network) {
    modulation = register_module("modulation", network->modulation());
    decoder = register_module("decoder", network->decoder());
  }
  torch::Tensor sdf(const torch::Tensor& points, const torch::Tensor& codes) {
    return decoder(points, modulation(codes));
  }
  torch::nn::Linear modulation{nullptr};
  FilmSdf decoder{nullptr};
};
TORCH_MODULE(Decoder);

/// A shape, turned: plants are learned in several directions, each with a code of its own.
struct Entry {
  const TrainingShape* shape = nullptr;
  double yaw = 0;
};

/// Adam on the rows that were used: a dense step would move all codes at every step.
class RowAdam {
 public:
  explicit RowAdam(const torch::Tensor& values)
      : mean(torch::zeros_like(values)),
        square(torch::zeros_like(values)),
        steps(torch::zeros({values.size(0), 1})) {}
  void step(torch::Tensor& values, const torch::Tensor& rows, const torch::Tensor& gradient,
            double rate) {
    const torch::NoGradGuard no_grad;
    const torch::Tensor m = 0.9 * mean.index_select(0, rows) + 0.1 * gradient;
    const torch::Tensor s = 0.99 * square.index_select(0, rows) + 0.01 * gradient * gradient;
    const torch::Tensor t = steps.index_select(0, rows) + 1;
    mean.index_copy_(0, rows, m);
    square.index_copy_(0, rows, s);
    steps.index_copy_(0, rows, t);
    const torch::Tensor corrected_m = m / (1 - torch::pow(0.9, t));
    const torch::Tensor corrected_s = s / (1 - torch::pow(0.99, t));
    values.index_copy_(
        0, rows, values.index_select(0, rows) - rate * corrected_m / (corrected_s.sqrt() + 1e-8));
  }
  torch::Tensor mean, square, steps;
};

struct Batch {
  torch::Tensor rows, points, distances;
};

Batch drawBatch(const std::vector<Entry>& entries, const std::vector<std::int64_t>& rows, int count,
                Random random) {
  Batch batch;
  const auto size = static_cast<std::int64_t>(rows.size());
  batch.rows = torch::tensor(rows);
  batch.points = torch::empty({size, count, 3});
  batch.distances = torch::empty({size, count});
  float* p = batch.points.data_ptr<float>();
  float* d = batch.distances.data_ptr<float>();
  for (const std::int64_t row : rows) {
    const Entry& entry = entries[static_cast<std::size_t>(row)];
    const auto c = static_cast<float>(std::cos(entry.yaw));
    const auto s = static_cast<float>(std::sin(entry.yaw));
    for (int i = 0; i < count; ++i) {
      const std::size_t k = random.index(static_cast<std::uint32_t>(entry.shape->points.size()));
      const Eigen::Vector3f& q = entry.shape->points[k];
      *p++ = c * q.x() - s * q.y();
      *p++ = s * q.x() + c * q.y();
      *p++ = q.z();
      *d++ = entry.shape->distances[k];
    }
  }
  return batch;
}

}  // namespace

std::optional<ShapeCodes> trainShapeDecoder(const CrispTrainingConfig& config,
                                            const TrainingPool& pool, PointNetwork network,
                                            const std::filesystem::path& out,
                                            const TrainingProgress& progress,
                                            const StopRequest& stop) {
  std::vector<Entry> entries;
  ShapeCodes result;
  Random yaw_random(config.seed, 11);
  for (const auto& [name, shapes] : pool.shapesByClass()) {
    for (const TrainingPool::Shape& shape : shapes) {
      if (shape.shape->yaw_symmetry != 0) {
        result.rows[shape.number] = static_cast<std::int64_t>(entries.size());
        entries.push_back({shape.shape, 0});
        continue;
      }
      for (int k = 0; k < 2; ++k) {
        entries.push_back({shape.shape, yaw_random.uniform(0, 2 * std::numbers::pi)});
      }
    }
  }
  torch::manual_seed(config.seed);
  Decoder master(network);
  torch::Tensor codes =
      config.decoder.code_deviation *
      torch::randn({static_cast<std::int64_t>(entries.size()), network->options().code});
  torch::optim::Adam optimizer(master->parameters(),
                               torch::optim::AdamOptions(config.decoder.learning_rate));
  RowAdam code_optimizer(codes);
  int step = 0;
  Checkpoint state(out / "decoder.checkpoint",
                   {{"step", [&] { return torch::tensor(step); },
                     [&](const torch::Tensor& t) { step = t.item<int>(); }}});
  state.add("codes", codes);
  state.add("code_mean", code_optimizer.mean);
  state.add("code_square", code_optimizer.square);
  state.add("code_steps", code_optimizer.steps);
  state.add("module", master.ptr());
  state.add("optimizer", optimizer);
  state.load();
  LossFile file(out / "loss.csv", "decoder", step);
  const bool half = wantsHalfPrecision(config.precision);
  Shards<Decoder> shards(master, config.shards,
                         [&] { return Decoder(PointNetwork(network->options())); });
  const CrispTrainingConfig::Decoder& phase = config.decoder;
  for (; step < phase.steps; ++step) {
    if (stop()) {
      state.save();
      return std::nullopt;
    }
    const double share = static_cast<double>(step) / phase.steps;
    const double decay = 0.02 + 0.98 * 0.5 * (1 + std::cos(std::numbers::pi * share));
    for (auto& group : optimizer.param_groups()) {
      static_cast<torch::optim::AdamOptions&>(group.options()).lr(phase.learning_rate * decay);
    }
    const Random random = Random(config.seed, 12).fork(static_cast<std::uint64_t>(step));
    std::vector<double> losses(shards.size());
    std::vector<Batch> batches(shards.size());
    std::vector<torch::Tensor> gradients(shards.size());
    parallelFor(shards.size(), [&](std::size_t k) {
      keepTorchOnThisThread();
      Random draw = random.fork(k);
      std::vector<std::int64_t> rows;
      const std::size_t share_of_step =
          std::min(static_cast<std::size_t>(phase.shapes_per_step) / shards.size(), entries.size());
      while (rows.size() < share_of_step) {
        const std::int64_t row = draw.index(static_cast<std::uint32_t>(entries.size()));
        if (std::find(rows.begin(), rows.end(), row) == rows.end()) rows.push_back(row);
      }
      batches[k] = drawBatch(entries, rows, phase.points_per_shape, draw);
      torch::Tensor used = codes.index_select(0, batches[k].rows).requires_grad_();
      torch::Tensor loss;
      {
        const Autocast autocast(half);
        loss = distanceLoss(shards[k]->sdf(batches[k].points, used), batches[k].distances,
                            config.target_clamp);
      }
      losses[k] = loss.item<double>();
      (loss + phase.code_penalty * used.square().sum(1).mean()).backward();
      gradients[k] = used.grad() * static_cast<double>(rows.size());
    });
    shards.collectGradients();
    torch::nn::utils::clip_grad_norm_(master->parameters(), 1.0);
    optimizer.step();
    for (std::size_t k = 0; k < shards.size(); ++k) {
      code_optimizer.step(codes, batches[k].rows, gradients[k], phase.code_learning_rate * decay);
    }
    double loss = 0;
    for (const double part : losses) loss += part / static_cast<double>(losses.size());
    progress("decoder", step + 1, phase.steps, {{"sdf", loss}});
    if ((step + 1) % kLossEvery == 0 || step + 1 == phase.steps) {
      file.line(step + 1, {{"samples", static_cast<double>(step + 1) * phase.shapes_per_step},
                           {"learning_rate", phase.learning_rate * decay},
                           {"sdf_l1", loss}});
    }
    if ((step + 1) % config.checkpoint_every == 0 || step + 1 == phase.steps) {
      ++step;
      state.save();
      --step;
    }
  }
  result.codes = codes;
  result.variance = codes.var(0).mean().item<double>();
  return result;
}

}  // namespace hydrabench

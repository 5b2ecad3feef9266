// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/training/latent_flow_training.h"

#include <fmt/format.h>

#include "core/io/atomic_file.h"
#include "core/shape/crisp/crisp_manifest.h"
#include "core/shape/crisp/small_crisp_model.h"
#include "core/shape/crisp/torch_weights.h"
#include "core/types/error.h"
#include "eval/training/latent_flow_losses.h"
#include "eval/training/training_folder.h"

namespace hydrabench {
namespace {

constexpr int kValidationBatches = 8;

template <typename Sample, typename Draw>
std::vector<Sample> drawAll(int count, Random random, const Draw& draw) {
  std::vector<Sample> samples;
  for (int i = 0; i < count; ++i)
    samples.push_back(draw(random.fork(static_cast<std::uint64_t>(i))));
  return samples;
}

/// Mean of a loss over held-out batches, its numbers named val_*.
template <typename Loss>
std::map<std::string, double> meanOf(const Loss& loss) {
  std::map<std::string, double> mean;
  for (int i = 0; i < kValidationBatches; ++i) {
    for (const auto& [name, value] : loss(Random(22, static_cast<std::uint64_t>(i))).numbers) {
      mean["val_" + name] += value / kValidationBatches;
    }
  }
  return mean;
}

/// Latents of all grids of a pool, in the order of LatentSample::latent; not normalised.
torch::Tensor encodeAll(ShapeAutoencoder& network, const FlowPool& pool) {
  constexpr std::size_t kBatch = 32;
  std::vector<const ShapeGrid*> grids;
  for (const TrainingPool::Shape& shape : pool.shapes()) {
    for (int i = 0; i < pool.grids(); ++i) {
      grids.push_back(&shape.shape->grids[static_cast<std::size_t>(i)]);
    }
  }
  std::vector<torch::Tensor> parts((grids.size() + kBatch - 1) / kBatch);
  parallelFor(parts.size(), [&](std::size_t i) {
    keepTorchOnThisThread();
    const torch::NoGradGuard no_grad;
    const auto begin = grids.begin() + static_cast<std::ptrdiff_t>(i * kBatch);
    const auto end =
        grids.begin() + static_cast<std::ptrdiff_t>(std::min(grids.size(), (i + 1) * kBatch));
    parts[i] = network->encode(makeGrids({begin, end}));
  });
  return torch::cat(parts);
}

/// The three phases, each begun when the one before is done.
class LatentFlowTraining {
 public:
  LatentFlowTraining(const LatentFlowTrainingConfig& config, const std::filesystem::path& out,
                     LatentFlowNetwork network, const FlowPool& pool, const FlowPool& held_out,
                     const TrainingProgress& progress, const StopRequest& stop)
      : config_(config),
        out_(out),
        network_(network),
        pool_(pool),
        held_out_(held_out),
        progress_(progress),
        stop_(stop) {}

  bool run() { return trainAutoencoder() && trainPose() && trainShape(); }

 private:
  bool trainAutoencoder() {
    const auto& phase = config_.autoencoder;
    const auto loss = [&](ShapeAutoencoder& module, const FlowPool& pool, int count,
                          Random random) {
      return autoencoderLoss(
          phase, module,
          drawAll<FieldSample>(count, random.fork(1),
                               [&](Random r) { return pool.drawField(phase.points, r); }),
          random.fork(2));
    };
    FlowPhase<ShapeAutoencoder> training(
        config_, phase, network_->autoencoder,
        {.name = "autoencoder",
         .make = [&] { return ShapeAutoencoder(autoencoderOptions(config_.network)); },
         .loss = [&](ShapeAutoencoder& module, int count,
                     Random random) { return loss(module, pool_, count, random); },
         .validate =
             [&](ShapeAutoencoder& module) {
               return meanOf([&](Random random) { return loss(module, held_out_, 32, random); });
             }},
        out_);
    if (!training.run(progress_, stop_)) return false;
    latents_ = encodeAll(network_->autoencoder, pool_);
    const torch::Tensor all = latents_.flatten(0, 1);
    if (config_.start_from.empty()) {  // else the flow knows the units it began with
      network_->autoencoder->setNormalization(all.mean(0), all.std(0).clamp_min(1e-4));
    }
    latents_ = network_->autoencoder->normalize(latents_);
    held_out_latents_ =
        network_->autoencoder->normalize(encodeAll(network_->autoencoder, held_out_));
    return true;
  }

  bool trainPose() {
    const auto loss = [&](PoseFlow& module, const FlowPool& pool, bool augment, int count,
                          Random random) {
      return poseFlowLoss(module,
                          drawAll<PoseSample>(count, random.fork(1),
                                              [&](Random r) { return pool.drawPose(augment, r); }),
                          random.fork(2));
    };
    FlowPhase<PoseFlow> training(
        config_, config_.pose, network_->pose,
        {.name = "pose",
         .make = [&] { return PoseFlow(poseFlowOptions(config_.network)); },
         .loss = [&](PoseFlow& module, int count,
                     Random random) { return loss(module, pool_, true, count, random); },
         .validate =
             [&](PoseFlow& module) {
               return meanOf(
                   [&](Random random) { return loss(module, held_out_, false, 32, random); });
             }},
        out_);
    return training.run(progress_, stop_);
  }

  bool trainShape() {
    const auto loss = [&](ShapeFlow& module, const FlowPool& pool, const torch::Tensor& latents,
                          bool augment, int count, Random random) {
      return shapeFlowLoss(
          module,
          drawAll<LatentSample>(count, random.fork(1),
                                [&](Random r) { return pool.drawLatent(augment, r); }),
          latents, augment ? config_.shape.condition_dropout : 0, random.fork(2));
    };
    FlowPhase<ShapeFlow> training(
        config_, config_.shape, network_->shape,
        {.name = "shape",
         .make = [&] { return ShapeFlow(shapeFlowOptions(config_.network)); },
         .loss = [&](ShapeFlow& module, int count,
                     Random random) { return loss(module, pool_, latents_, true, count, random); },
         .validate =
             [&](ShapeFlow& module) {
               return meanOf([&](Random random) {
                 return loss(module, held_out_, held_out_latents_, false, 32, random);
               });
             }},
        out_);
    return training.run(progress_, stop_);
  }

  const LatentFlowTrainingConfig& config_;
  std::filesystem::path out_;
  LatentFlowNetwork network_;
  const FlowPool& pool_;
  const FlowPool& held_out_;
  const TrainingProgress& progress_;
  const StopRequest& stop_;
  torch::Tensor latents_;
  torch::Tensor held_out_latents_;
};

/// Copies what the encoder of views has in common with a small CRISP network: all of it.
void beginViewEncoder(const std::filesystem::path& folder, PointEncoder encoder) {
  const CrispManifest manifest = readCrispManifest(folder / "manifest.yaml");
  const PointNetwork crisp = loadPointNetwork(manifest);
  const torch::NoGradGuard no_grad;
  const auto from = crisp->named_parameters();
  for (auto& item : encoder->named_parameters()) {
    const torch::Tensor* value = from.find(item.key());
    if (!value || value->sizes() != item.value().sizes()) {
      throw InputError(
          fmt::format("view_encoder_from: {} has no encoder of the sizes of "
                      "network.view_*, expected one of {} x {}",
                      folder.string(), manifest.encoder_dim, manifest.encoder_depth));
    }
    item.value().copy_(*value);
  }
}

void writeModel(const LatentFlowTrainingConfig& config, const std::filesystem::path& folder,
                LatentFlowNetwork network) {
  std::filesystem::create_directories(folder);
  LatentFlowManifest manifest;
  manifest.network = config.network;
  manifest.source = "hydrabench train, on worlds of the built-in generator";
  manifest.licence = "MIT";
  saveWeights(*network, folder / manifest.weights, {{"format", "pt"}}, TensorType::kF16);
  writeFileAtomic(folder / "manifest.yaml", toYaml(manifest));
}

}  // namespace

TrainingState trainLatentFlow(const LatentFlowTrainingConfig& config, const std::string& resolved,
                              const std::filesystem::path& out, const TrainingProgress& progress,
                              const StopRequest& stop) {
  beginTraining(out, resolved, config.seed);
  LatentFlowNetwork network(config.network);
  if (!config.start_from.empty()) {
    loadWeights(*network, readLatentFlowManifest(config.start_from / "manifest.yaml").weights);
  } else if (!config.view_encoder_from.empty()) {
    beginViewEncoder(config.view_encoder_from, network->pose->encoder());
  }
  const auto making = [&](int world, int worlds) {
    progress("worlds", world, worlds, {});
    return !stop();
  };
  const FlowPool held_out(config, InstanceSplit::kValidation, out / "worlds", making);
  if (!held_out.complete()) return TrainingState::kNoNetworkYet;
  const FlowPool pool(config, InstanceSplit::kTraining, out / "worlds", making);
  if (!pool.complete()) return TrainingState::kNoNetworkYet;
  LatentFlowTraining training(config, out, network, pool, held_out, progress, stop);
  const bool finished = training.run();
  writeModel(config, out / "model", network);
  return finished ? TrainingState::kFinished : TrainingState::kStopped;
}

}  // namespace hydrabench

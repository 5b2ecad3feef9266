// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/training/crisp_training.h"

#include "core/io/atomic_file.h"
#include "core/shape/crisp/crisp_manifest.h"
#include "core/shape/crisp/torch_weights.h"
#include "eval/training/crisp_trainer.h"
#include "eval/training/training_folder.h"

namespace hydrabench {
namespace {

constexpr double kCubeHalfSide = 1.1;  // shapes reach to 1; plants seen at an angle little farther

void writeModel(const CrispTrainingConfig& config, const std::filesystem::path& folder,
                PointNetwork network) {
  std::filesystem::create_directories(folder);
  CrispManifest manifest;
  manifest.preset = "small";
  manifest.mode = "normalised";
  manifest.input_normalisation = "none";
  manifest.crop = "none";
  manifest.cube_half_side = kCubeHalfSide;
  manifest.sdf_layers = config.network.decoder_layers;
  manifest.sdf_width = config.network.decoder_width;
  manifest.encoder_dim = config.network.dim;
  manifest.encoder_depth = config.network.depth;
  manifest.encoder_heads = config.network.heads;
  manifest.source = "hydrabench train, on worlds of the built-in generator";
  manifest.licence = "MIT";
  saveWeights(*network, folder / manifest.weights, {{"format", "pt"}}, TensorType::kF16);
  writeFileAtomic(folder / "manifest.yaml", toYaml(manifest));
}

}  // namespace

TrainingState trainCrispModel(const CrispTrainingConfig& config, const std::string& resolved,
                              const std::filesystem::path& out, const TrainingProgress& progress,
                              const StopRequest& stop) {
  beginTraining(out, resolved, config.seed);
  PointNetwork network(networkOptions(config));
  if (!config.start_from.empty() && !std::filesystem::exists(out / "network.checkpoint")) {
    loadWeights(*network, readCrispManifest(config.start_from / "manifest.yaml").weights);
  }
  const TrainingState state = trainCrisp(config, out, network, progress, stop);
  if (state != TrainingState::kNoNetworkYet) writeModel(config, out / "model", network);
  return state;
}

}  // namespace hydrabench

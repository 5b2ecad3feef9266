// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

#include "core/config/config_reader.h"

namespace hydrabench {

/// Sizes of the networks of a latent flow: what its weights fit.
struct LatentFlowSizes {
  int latent = 24;    ///< channels of a latent voxel
  int features = 24;  ///< of a cell of the decoder
  int hidden = 64;    ///< of the layers between features and distance
  int autoencoder_dim = 192;
  int encoder_depth = 1;
  int decoder_depth = 2;
  int autoencoder_heads = 6;
  int flow_dim = 192;  ///< of the flow of shapes
  int flow_depth = 6;
  int flow_heads = 6;
  int pose_dim = 128;  ///< of the flow of poses
  int pose_depth = 3;
  int pose_heads = 4;
  int view_dim = 192;  ///< of the encoder of measured points, as the small CRISP network's
  int view_depth = 6;
  int view_heads = 3;
};
/// Faults where heads do not divide dimensions.
void read(ConfigReader& reader, LatentFlowSizes& sizes);

/// What stands beside the weights of a latent flow.
struct LatentFlowManifest {
  LatentFlowSizes network;
  std::filesystem::path weights = "weights.safetensors";  ///< relative to the manifest
  std::string source;                                     ///< where the weights come from
  std::string licence;
};

/// Throws InputError naming file, key, value and what was expected.
LatentFlowManifest readLatentFlowManifest(const std::filesystem::path& path);

/// As YAML that readLatentFlowManifest() understands, `weights` as it stands.
std::string toYaml(const LatentFlowManifest& manifest);

}  // namespace hydrabench

// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "core/shape/latent_flow/latent_flow_manifest.h"

#include <fmt/format.h>

namespace hydrabench {
namespace {

void readHeads(ConfigReader& reader, const char* key, int& heads, int dim) {
  reader.field(key, heads, {1, 64});
  if (heads > 0 && dim % heads != 0) {
    reader.fault(
        key, fmt::format("{} heads do not divide a width of {}, expected a divisor", heads, dim));
  }
}

void read(ConfigReader& reader, LatentFlowManifest& manifest) {
  auto network = reader.section("network");
  read(network, manifest.network);
  reader.path("weights", manifest.weights);
  reader.field("source", manifest.source);
  reader.field("licence", manifest.licence);
}

}  // namespace

void read(ConfigReader& reader, LatentFlowSizes& sizes) {
  reader.field("latent", sizes.latent, {1, 1024});
  reader.field("features", sizes.features, {1, 1024});
  reader.field("hidden", sizes.hidden, {1, 4096});
  reader.field("autoencoder_dim", sizes.autoencoder_dim, {8, 4096});
  reader.field("encoder_depth", sizes.encoder_depth, {0, 64});
  reader.field("decoder_depth", sizes.decoder_depth, {0, 64});
  readHeads(reader, "autoencoder_heads", sizes.autoencoder_heads, sizes.autoencoder_dim);
  reader.field("flow_dim", sizes.flow_dim, {8, 4096});
  reader.field("flow_depth", sizes.flow_depth, {1, 64});
  readHeads(reader, "flow_heads", sizes.flow_heads, sizes.flow_dim);
  reader.field("pose_dim", sizes.pose_dim, {8, 4096});
  reader.field("pose_depth", sizes.pose_depth, {1, 64});
  readHeads(reader, "pose_heads", sizes.pose_heads, sizes.pose_dim);
  reader.field("view_dim", sizes.view_dim, {8, 4096});
  reader.field("view_depth", sizes.view_depth, {1, 64});
  readHeads(reader, "view_heads", sizes.view_heads, sizes.view_dim);
}

LatentFlowManifest readLatentFlowManifest(const std::filesystem::path& path) {
  ConfigReader reader(ConfigDocument::fromFile(path));
  for (const char* key : {"network", "weights"}) reader.require(key);
  LatentFlowManifest manifest;
  read(reader, manifest);
  reader.finish();
  return manifest;
}

std::string toYaml(const LatentFlowManifest& manifest) {
  ConfigReader reader(ConfigDocument::fromString("{}"));
  LatentFlowManifest copy = manifest;
  read(reader, copy);
  return reader.resolved();
}

}  // namespace hydrabench

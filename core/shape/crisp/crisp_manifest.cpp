// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "core/shape/crisp/crisp_manifest.h"

#include "core/config/config_reader.h"

namespace hydrabench {
namespace {

void read(ConfigReader& reader, CrispManifest& manifest) {
  reader.choice("preset", manifest.preset, {"full", "small"});
  reader.choice("mode", manifest.mode, {"metric", "normalised"});
  reader.choice("input_normalisation", manifest.input_normalisation, {"imagenet", "none"});
  reader.choice("crop", manifest.crop, {"tight_stretch", "none"});
  reader.field("cube_half_side", manifest.cube_half_side, Bounds{1e-3, 1e3});
  reader.field("sdf_layers", manifest.sdf_layers, Bounds{1, 64});
  reader.field("sdf_width", manifest.sdf_width, Bounds{1, 4096});
  if (manifest.preset == "small") {
    reader.field("encoder_dim", manifest.encoder_dim, Bounds{8, 4096});
    reader.field("encoder_depth", manifest.encoder_depth, Bounds{1, 64});
    reader.field("encoder_heads", manifest.encoder_heads, Bounds{1, 64});
  }
  reader.path("weights", manifest.weights);
  reader.field("source", manifest.source);
  reader.field("licence", manifest.licence);
  reader.field("git_hash", manifest.git_hash);
}

}  // namespace

CrispManifest readCrispManifest(const std::filesystem::path& path) {
  ConfigReader reader(ConfigDocument::fromFile(path));
  // Defaults would guess at what the weights mean.
  for (const char* key : {"preset", "mode", "input_normalisation", "crop", "cube_half_side",
                          "sdf_layers", "sdf_width", "weights"}) {
    reader.require(key);
  }
  CrispManifest manifest;
  read(reader, manifest);
  reader.finish();
  return manifest;
}

std::string toYaml(const CrispManifest& manifest) {
  ConfigReader reader(ConfigDocument::fromString("{}"));
  CrispManifest copy = manifest;
  read(reader, copy);
  return reader.resolved();
}

}  // namespace hydrabench

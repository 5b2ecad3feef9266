// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

namespace hydrabench {

/// What weights of CRISP mean and how their input is made. It stands beside them, because none of
/// it can be told from the numbers: flags decide.
struct CrispManifest {
  std::string preset = "full";  ///< full | small
  /// metric: object coordinates are metres, the pose has no scale. normalised: [0, 1] in the unit
  /// cube, v stands for the point 2 (v - 0.5), the pose has a scale. CRISP's published weights are
  /// metric.
  std::string mode = "metric";
  std::string input_normalisation = "imagenet";  ///< imagenet | none (colours in [0, 1])
  std::string crop =
      "tight_stretch";          ///< tight_stretch (CrispCrop) | none (whole image, or no image)
  double cube_half_side = 1.0;  ///< where the decoder was trained: [m], or 1 if normalised
  int sdf_layers = 5;           ///< of the decoder
  int sdf_width = 256;
  int encoder_dim = 192;  ///< of the small preset's transformer
  int encoder_depth = 6;
  int encoder_heads = 3;
  std::filesystem::path weights = "weights.safetensors";  ///< relative to the manifest
  std::string source;                                     ///< where the weights come from
  std::string licence;
  std::string git_hash;  ///< of the code that trained them

  bool isMetric() const { return mode == "metric"; }
};

/// Throws InputError naming file, key, value and what was expected.
CrispManifest readCrispManifest(const std::filesystem::path& path);

/// As YAML that readCrispManifest() understands, `weights` as it stands.
std::string toYaml(const CrispManifest& manifest);

}  // namespace hydrabench

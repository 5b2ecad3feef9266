// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>

#include "core/config/config_reader.h"
#include "core/types/ids.h"

namespace hydrabench {

/// What the voxels of one block know of their class.
class SemanticBlock {
 public:
  virtual ~SemanticBlock() = default;
  virtual void fuse(std::size_t voxel, Label label, float weight) = 0;
  /// Most likely class; nullopt before the first measurement.
  virtual std::optional<Label> label(std::size_t voxel) const = 0;
  /// Share of the evidence that speaks for `label`, in [0, 1]; nullopt before the first
  /// measurement.
  virtual std::optional<float> share(std::size_t voxel, Label label) const = 0;
};

/// How labels of several measurements become one:
///   none          no labels are kept
///   single_label  one label with a weight that others wear down; used by Hydra on uHumans2
///   mle           log-likelihood per label, 0.9 for the measured one, 0.1 for each other
///   first_k       counts of the first 5 labels that a voxel meets
///   binary        counts of label 1 against any other; Khronos' object reconstruction
struct SemanticFusionConfig {
  std::string type = "single_label";
  int num_labels = 64;  ///< mle: labels from 0 to num_labels - 1; others are passed over
  int first_k = 5;
};

/// nullptr for type none.
std::unique_ptr<SemanticBlock> makeSemanticBlock(const SemanticFusionConfig& config,
                                                 std::size_t num_voxels);

void read(ConfigReader& reader, SemanticFusionConfig& config);

}  // namespace hydrabench

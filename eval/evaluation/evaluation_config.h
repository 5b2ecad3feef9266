// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "core/config/config_reader.h"
#include "eval/evaluation/scene_config.h"
#include "metrics/bootstrap.h"
#include "metrics/object_model.h"

namespace hydrabench {

/// How objects are scored; the section `evaluation` of a config. docs/metrics.md defines the terms.
struct EvaluationConfig {
  std::vector<double> thresholds_m = {0.2, 0.5};  ///< tau_d of the tables
  std::vector<double> kappas = {0.25, 0.5, 1.0};  ///< size-relative thresholds, detection only
  double kappa_max = 1.0;                         ///< end of the sweep and of the area under F1
  int samples = 10000;                            ///< points per surface
  double voxel_pitch_m = 0.05;
  int jittered_origins = 8;        ///< shifted grids for the spread of v_iou
  int bootstrap_resamples = 2000;  ///< 0: no intervals
  std::uint64_t seed = 0;          ///< of samples and resamples
  /// Ground truth of which less than this share was ever in view is neither found nor missed; an
  /// estimate that is nearest to such an object, within its half diagonal, is not counted either.
  double min_visible_fraction = 0;
  SceneScoringConfig scene = {};

  ObjectModel::Config modelConfig() const;
  BootstrapConfig bootstrapConfig() const;
  friend bool operator==(const EvaluationConfig&, const EvaluationConfig&) = default;
};

void read(ConfigReader& reader, EvaluationConfig& config);
std::string toYaml(EvaluationConfig config);

}  // namespace hydrabench

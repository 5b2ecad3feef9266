// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "core/config/config_reader.h"

namespace hydrabench {

/// How the map as a whole is scored; the section `evaluation.scene`. docs/metrics.md, "Scene".
struct SceneScoringConfig {
  bool enabled = false;
  double radius_m = 20;          ///< around the path, on the ground plan
  double points_per_m2 = 25;     ///< of either surface
  double voxel_m = 0.2;          ///< ground is covered by what is no farther
  double square_m = 10;          ///< of the ground plan: what intervals are drawn over
  double eye_spacing_m = 1;      ///< of the places on the path that decide what was in view
  double feature_reach_m = 3.5;  ///< nearer to one of `features` than this, falsely filled volume
                                 ///< is stated under its name
  std::vector<std::string> ground;  ///< names of classes; empty: those the dataset calls ground
  /// Names of classes that make edges; "kerb" is every other upright piece of ground.
  std::vector<std::string> features = {"stairs", "wall"};

  friend bool operator==(const SceneScoringConfig&, const SceneScoringConfig&) = default;
};

void read(ConfigReader& reader, SceneScoringConfig& config);

}  // namespace hydrabench

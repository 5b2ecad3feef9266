// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/config/config_reader.h"
#include "eval/simulation/scene.h"

namespace hydrabench {

/// A world made of mesh files and poses: a JSON with `instances`, each with name, class,
/// is_structure, mesh (file), T_world_object (4 x 4) and mean_rgb.
struct PlacedMeshesConfig {
  /// What to do with the instances of a class, or with the one of a name, which goes first.
  struct Rule {
    std::string class_name;  ///< of the JSON; empty where `name` is given
    std::string name;
    std::string label;  ///< of the office label space
    bool structure =
        false;  ///< labelled pixels without an instance, as the flag is_structure of the JSON says
  };
  std::filesystem::path scene;
  std::vector<Rule> rules;
  std::vector<Room> rooms;  ///< where the robot may be; lamps hang in each
  double lamp_height_m = 2.8;
  double lamp_spacing_m = 3.5;
  double lamp_intensity = 4;  ///< irradiance at 1 m, 1 being white on white
};
void read(ConfigReader& reader, PlacedMeshesConfig& config);

/// Throws InputError naming file, instance and field; for an instance that no rule is for.
Scene makePlacedMeshesScene(const PlacedMeshesConfig& config);

}  // namespace hydrabench

// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/config/config_reader.h"
#include "eval/simulation/floor_plan.h"
#include "eval/simulation/furnisher.h"
#include "eval/simulation/scene.h"

namespace hydrabench {

/// The built-in office.
struct OfficeConfig {
  std::string world = "office";  ///< "office": eight rooms and a corridor; "quick": two rooms and a
                                 ///< piece of corridor
  int chairs = 52;
  int couches = 10;
  int plants = 12;
  int bins = 14;       ///< water dispensers included
  int computers = 18;  ///< outside the trained classes
  bool score_computers = false;
  /// Split of the shape families that objects are drawn from. No config key: whatever a user
  /// evaluates on is the evaluation split; trainers ask for the others.
  InstanceSplit split = InstanceSplit::kEvaluation;

  static OfficeConfig quick();
};
void read(ConfigReader& reader, OfficeConfig& config);

/// Where everything stands, before anything is meshed.
struct OfficeLayout {
  FloorPlan plan;
  std::vector<Furnisher::Placed> pieces;
};
OfficeLayout layOutOffice(const OfficeConfig& config, std::uint64_t seed);

/// A function of config and seed. Where the rooms do not hold as many objects of a class as asked
/// for, there are fewer.
Scene makeOffice(const OfficeConfig& config, std::uint64_t seed);

}  // namespace hydrabench

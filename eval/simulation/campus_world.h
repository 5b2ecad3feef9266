// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/config/config_reader.h"
#include "eval/simulation/campus_terrain.h"
#include "eval/simulation/placed_shape.h"
#include "eval/simulation/scene.h"

namespace hydrabench {

/// The built-in campus: a street around a lawn, out of doors.
struct CampusConfig {
  std::string world = "campus";  ///< "campus": all of it; "campus_quick": objects along some 40 m
                                 ///< of the way only, with steps, terrace and slope
  int hydrants = 18;
  int cars = 26;
  int benches = 24;
  /// Cars that drive and people who walk, in addition to what stands (campus_traffic.h).
  struct Movers {
    int cars = 0;
    int pedestrians = 0;
    bool any() const { return cars + pedestrians > 0; }
  };
  Movers movers;
  /// As OfficeConfig::split.
  InstanceSplit split = InstanceSplit::kEvaluation;

  static CampusConfig quick();
};
void read(ConfigReader& reader, CampusConfig& config);

/// The robot's way: the inner pavement, once around, or a stretch of it.
struct CampusWay {
  /// Offset of the way from the middle of the road: on the inner pavement, nearer to the kerb.
  static constexpr double kOffset_m = -(CampusTerrain::kRoadHalfWidth_m + 1.25);
  static constexpr double kClearance_m = 0.55;  ///< to all objects, at least
  double from_m = 0;                            ///< along the loop at kOffset_m
  double to_m = 0;
};
CampusWay campusWay(const CampusConfig& config, const CampusTerrain& terrain);

/// Ground and objects before anything is meshed. A function of config and seed.
struct CampusLayout {
  CampusTerrain terrain;
  CampusWay way;
  std::vector<PlacedShape> objects;  ///< scored ones first
};
CampusLayout layOutCampus(const CampusConfig& config, std::uint64_t seed);

/// Ground of the campus of a seed.
CampusTerrain campusTerrain(std::uint64_t seed);

/// Ground, houses, objects, sun; no movers yet. Where the street does not hold as many objects of a
/// class as asked for, there are fewer.
Scene makeCampus(const CampusConfig& config, std::uint64_t seed);

}  // namespace hydrabench

// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/types/random.h"
#include "eval/simulation/campus_terrain.h"
#include "eval/simulation/scene.h"

namespace hydrabench {

/// Offset of the nearest front from the middle of the road [m].
inline constexpr double kNearestFront_m = 12.5;

/// Adds houses along the outer side of the road: boxes with windows, doors and a roof, structure
/// without instances.
void buildCampusBuildings(const CampusTerrain& terrain, Random random, Scene& scene);

}  // namespace hydrabench

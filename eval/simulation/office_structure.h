// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include "eval/simulation/floor_plan.h"
#include "eval/simulation/scene.h"

namespace hydrabench {

inline constexpr double kDoorHeight_m = 2.1;

/// Adds the rooms of a plan to the scene: floors, walls with their openings, door frames and open
/// leaves, windows, ceiling and lamps.
void buildStructure(const FloorPlan& plan, Random random, Scene& scene);

/// Floor area that must stay free: in front of doors on both sides, and under the open leaves.
std::vector<Rect> keepOutAreas(const FloorPlan& plan);

}  // namespace hydrabench

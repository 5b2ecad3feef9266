// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "eval/simulation/campus_world.h"

namespace hydrabench {

/// Cars in bays along the kerbs, hydrants behind them, benches at the back of the pavements, and
/// street furniture and trees, along the way. Nothing touches anything else or stands on the way.
/// Cars lean with the road; everything else stands upright, benches where it is level. Three
/// quarters of the scored ones stand on the side of the way, the others across the road.
std::vector<PlacedShape> placeCampusObjects(const CampusConfig& config,
                                            const CampusTerrain& terrain, const CampusWay& way,
                                            std::uint64_t seed);

}  // namespace hydrabench

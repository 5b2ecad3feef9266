// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "eval/simulation/campus_world.h"

namespace hydrabench {

/// Cars that drive along the road and people who walk on the pavements, round and round.
///
/// They move in lanes along the loop, each with one direction and one speed, so that nobody catches
/// up: cars, all one way, at 3.5 to 5 m/s in the middle of the road, between the parked ones;
/// people at 0.9 to 1.6 m/s on the outer pavement, in both directions where it is wide enough, and
/// on the inner one between the robot's way and the lawn. Lanes keep clear of everything that
/// stands and the robot's way is nobody's lane: nobody has to give way, and no drive changes.
///
/// Adds movers to a campus of the same config and seed, for the time from 0 to `end_ns`, and the
/// class "human" to its label space if somebody walks. A function of its arguments. A car too wide
/// for the lane is drawn anew; where none of several fits, there are fewer.
void addCampusTraffic(const CampusConfig& config, std::uint64_t seed, std::int64_t end_ns,
                      Scene& scene);

/// At most so many: they keep 4 m (cars) and half a metre (people) between each other.
inline constexpr int kMaxMovingCars = 16;
inline constexpr int kMaxPedestrians = 120;

}  // namespace hydrabench

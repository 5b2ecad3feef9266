// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include "eval/simulation/floor_plan.h"
#include "eval/simulation/room_fitter.h"

namespace hydrabench {

/// The recipe of each kind of room: puts its furniture down and offers slots for chairs, couches,
/// plants, bins and computers.
void furnishRoom(RoomKind kind, RoomFitter& room);

}  // namespace hydrabench

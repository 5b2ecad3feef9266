// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include "eval/simulation/shape_family.h"

namespace hydrabench {

/// Furniture made to measure for a room: its size follows from the plan instead of being drawn.
/// Object frame as for all shapes.
namespace fitted {

/// Screens of an island of desks, front along x: one along y in the middle and wings between
/// neighbouring desks.
/// @param desks  number of desks on each side; @param pitch_m  from one desk to the next along y;
/// @param reach_m  of a wing
ShapeInstance cubicleScreens(int desks, double pitch_m, double reach_m, double height_m,
                             Random random);

/// Long table along y with panel legs.
ShapeInstance conferenceTable(double length_m, double width_m, Random random);
/// Row of kitchen cupboards along y with a worktop and a sink.
ShapeInstance kitchenCounter(double length_m, Random random);
/// Desk behind a raised front along y; visitors stand at +x, the clerk sits at -x.
ShapeInstance receptionDesk(double length_m, Random random);
/// Floor-standing copier.
ShapeInstance copier(Random random);
/// Board with a tray, to hang on a wall: its lower edge at z = 0.
ShapeInstance whiteboard(double width_m, double height_m);

}  // namespace fitted
}  // namespace hydrabench

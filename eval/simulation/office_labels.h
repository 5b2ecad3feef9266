// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/types/label_space.h"

namespace hydrabench {

/// Label ids of the uHumans2 office (Hydra's uhumans2_office label space), so that existing configs
/// fit. Doors and shelves count as cabinets there, tables as desks, windows as walls, and a water
/// dispenser as a bin.
namespace office_label {
inline constexpr Label kBooks = 2;
inline constexpr Label kFloor = 3;
inline constexpr Label kCeiling = 4;
inline constexpr Label kChair = 5;
inline constexpr Label kCouch = 7;
inline constexpr Label kCabinet = 9;
inline constexpr Label kComputer = 10;
inline constexpr Label kLamp = 11;
inline constexpr Label kPlant = 13;
inline constexpr Label kSign = 14;
inline constexpr Label kDesk = 16;
inline constexpr Label kCubicle = 17;
inline constexpr Label kBin = 18;
inline constexpr Label kWall = 19;
}  // namespace office_label

/// Chair, couch, plant and bin are scored. Computers are objects outside the trained classes and
/// are scored on request only.
LabelSpace officeLabelSpace(bool score_computers);

}  // namespace hydrabench

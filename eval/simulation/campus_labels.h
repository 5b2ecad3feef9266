// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/types/label_space.h"

namespace hydrabench {

/// Label ids of the outdoor worlds. The sky has none: nothing is hit there.
namespace campus_label {
inline constexpr Label kRoad = 1;
inline constexpr Label kSidewalk = 2;
inline constexpr Label kGrass = 3;
inline constexpr Label kStairs = 4;
inline constexpr Label kWall = 5;  ///< retaining walls
inline constexpr Label kBuilding = 6;
inline constexpr Label kTree = 7;
inline constexpr Label kLampPole = 8;
inline constexpr Label kBollard = 9;
inline constexpr Label kSign = 10;
inline constexpr Label kFireHydrant = 11;
inline constexpr Label kCar = 12;
inline constexpr Label kBench = 13;
inline constexpr Label kHuman = 14;  ///< in the label space where there are pedestrians only
}  // namespace campus_label

/// Hydrants, cars and benches are scored; road, sidewalk, grass and stairs are ground.
LabelSpace campusLabelSpace();

}  // namespace hydrabench

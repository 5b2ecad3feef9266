// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include <Eigen/Core>

#include "core/types/frame.h"

namespace hydrabench {

/// Throws InputError, naming the stamp and what is wrong, unless the frame has a depth image, all
/// images it has are of the camera's size, and its pose is finite.
void requireUsable(const Frame& frame);

/// Throws InputError, naming the stamp, where cells of a grid around a position have numbers above
/// 2^30: they would soon not fit into an int, and the map would be silently wrong.
/// @param position  of the sensor or of what is mapped, in the world [m]
/// @param cell_m    size of the finest grid in use
void requireInsideGrid(std::int64_t stamp_ns, const Eigen::Vector3d& position, double cell_m);

}  // namespace hydrabench

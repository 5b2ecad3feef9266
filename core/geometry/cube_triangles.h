// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace hydrabench {

/// Cut edges of the cube; counter-clockwise seen from outside the shape.
using CubeTriangle = std::array<std::uint8_t, 3>;

/// The table of marching cubes (Lorensen and Cline, SIGGRAPH 1987), derived instead of typed.
/// The contours of core/geometry/cube_contours.h, triangulated without an extra vertex: no crack
/// opens between cubes, and no triangle has an edge inside a face that the neighbour's could
/// coincide with.
/// @param inside_mask  bit c: corner c is inside
const std::vector<CubeTriangle>& cubeTriangles(int inside_mask);

}  // namespace hydrabench

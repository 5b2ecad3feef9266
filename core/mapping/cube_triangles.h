// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace hydrabench {

// Corner c of a cube lies at (c & 1, c >> 1 & 1, c >> 2 & 1). Edge e (of 12) runs along axis e / 4
// from its lower corner, so that all cubes around an edge agree on its direction.
constexpr int cubeEdgeLow(int edge) {
  const int axis = edge / 4;
  return ((edge & 1) << ((axis + 1) % 3)) | ((edge >> 1 & 1) << ((axis + 2) % 3));
}
constexpr int cubeEdgeHigh(int edge) { return cubeEdgeLow(edge) | (1 << (edge / 4)); }

/// Cut edges of the cube; counter-clockwise seen from outside the shape.
using CubeTriangle = std::array<std::uint8_t, 3>;

/// The table of marching cubes (Lorensen and Cline, SIGGRAPH 1987), derived instead of typed.
/// A face with two inside corners across from each other is ambiguous: such corners are kept apart.
/// That is decided by the face alone, so both cubes at a face draw the same lines on it, and no
/// crack opens. No triangle has an edge inside a face that the neighbour's could coincide with.
/// @param inside_mask  bit c: corner c is inside
const std::vector<CubeTriangle>& cubeTriangles(int inside_mask);

}  // namespace hydrabench

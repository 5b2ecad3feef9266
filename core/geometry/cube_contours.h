// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

namespace hydrabench {

// Corner c of a cube lies at (c & 1, c >> 1 & 1, c >> 2 & 1). Edge e (of 12) runs along axis e / 4
// from cubeEdgeStart(e).
constexpr int cubeEdgeStart(int edge) {
  const int axis = edge / 4;
  const int u = (axis + 1) % 3;
  const int v = (axis + 2) % 3;
  return ((edge & 1) << u) | ((edge >> 1 & 1) << v);
}
constexpr int cubeEdgeEnd(int edge) { return cubeEdgeStart(edge) | (1 << (edge / 4)); }

bool shareCubeFace(int edge_a, int edge_b);

/// A closed contour of the zero set on the surface of a grid cube: cut edges in order,
/// counter-clockwise seen from outside the shape.
struct CubeContour {
  std::vector<int> edges;
  bool fan_at_first = true;  ///< triangles fan out from the first edge's vertex; otherwise from an
                             ///< extra vertex in the middle
};

/// Contours of a cube whose corners lie inside as the 8 bits say. On an ambiguous face (two inside
/// corners across from each other) the inside corners are kept apart, which looks the same from
/// both sides; and no fan's diagonal lies within a face, where the neighbour could have the same.
/// So meshes of these fans are closed 2-manifolds, whatever the signs.
const std::vector<CubeContour>& cubeContours(int inside_mask);

}  // namespace hydrabench

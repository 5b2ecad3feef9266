// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "core/mapping/cube_triangles.h"

#include <algorithm>
#include <cstddef>

namespace hydrabench {
namespace {

using Contour = std::vector<int>;  // cut edges around one piece of the surface

int edgeBetween(int a, int b) {
  int edge = 0;
  while (cubeEdgeLow(edge) != std::min(a, b) || cubeEdgeHigh(edge) != std::max(a, b)) ++edge;
  return edge;
}

bool onCommonFace(int edge_a, int edge_b) {
  const int all =
      cubeEdgeLow(edge_a) & cubeEdgeHigh(edge_a) & cubeEdgeLow(edge_b) & cubeEdgeHigh(edge_b);
  const int any =
      cubeEdgeLow(edge_a) | cubeEdgeHigh(edge_a) | cubeEdgeLow(edge_b) | cubeEdgeHigh(edge_b);
  return all != 0 || any != 7;
}

/// For each cut edge the next one on its contour. On a face, walked counter-clockwise seen from
/// outside the cube, a line joins the place where a run of inside corners is entered with the one
/// where it is left.
std::array<int, 12> linesOnFaces(int inside_mask) {
  const auto inside = [&](int corner) { return (inside_mask >> corner & 1) != 0; };
  std::array<int, 12> next;
  next.fill(-1);
  for (int axis = 0; axis < 3; ++axis) {
    const int u = 1 << ((axis + 1) % 3);
    const int v = 1 << ((axis + 2) % 3);
    for (int base : {0, 1 << axis}) {
      std::array<int, 4> ring = {base, base | u, base | u | v, base | v};
      if (base == 0) std::reverse(ring.begin(), ring.end());
      for (std::size_t i = 0; i < 4; ++i) {
        if (inside(ring[i]) || !inside(ring[(i + 1) % 4])) continue;
        std::size_t last = (i + 1) % 4;
        while (inside(ring[(last + 1) % 4])) last = (last + 1) % 4;
        next[static_cast<std::size_t>(edgeBetween(ring[i], ring[(i + 1) % 4]))] =
            edgeBetween(ring[last], ring[(last + 1) % 4]);
      }
    }
  }
  return next;
}

/// Cuts off corner after corner, such that no cut lies within a face of the cube where that is
/// possible.
bool triangulate(const Contour& contour, bool avoid_faces, std::vector<CubeTriangle>& triangles) {
  const std::size_t n = contour.size();
  for (std::size_t i = 0; i < n; ++i) {
    const int before = contour[(i + n - 1) % n];
    const int after = contour[(i + 1) % n];
    if (n > 3 && avoid_faces && onCommonFace(before, after)) continue;
    triangles.push_back({static_cast<std::uint8_t>(before), static_cast<std::uint8_t>(contour[i]),
                         static_cast<std::uint8_t>(after)});
    if (n == 3) return true;
    Contour rest = contour;
    rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(i));
    if (triangulate(rest, avoid_faces, triangles)) return true;
    triangles.pop_back();
  }
  return false;
}

std::vector<CubeTriangle> trianglesOfCase(int inside_mask) {
  std::array<int, 12> next = linesOnFaces(inside_mask);
  std::vector<CubeTriangle> triangles;
  for (int start = 0; start < 12; ++start) {
    Contour contour;
    for (int edge = start; next[static_cast<std::size_t>(edge)] >= 0;) {
      contour.push_back(edge);
      const int following = next[static_cast<std::size_t>(edge)];
      next[static_cast<std::size_t>(edge)] = -1;
      edge = following;
    }
    if (contour.empty()) continue;
    if (!triangulate(contour, true, triangles)) triangulate(contour, false, triangles);
  }
  return triangles;
}

}  // namespace

const std::vector<CubeTriangle>& cubeTriangles(int inside_mask) {
  static const std::vector<std::vector<CubeTriangle>> table = [] {
    std::vector<std::vector<CubeTriangle>> cases;
    for (int mask = 0; mask < 256; ++mask) cases.push_back(trianglesOfCase(mask));
    return cases;
  }();
  return table[static_cast<std::size_t>(inside_mask)];
}

}  // namespace hydrabench

// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "core/geometry/cube_triangles.h"

#include <cstddef>

#include "core/geometry/cube_contours.h"

namespace hydrabench {
namespace {

/// Cuts off corner after corner, such that no cut lies within a face of the cube where that is
/// possible.
bool triangulate(const std::vector<int>& contour, bool avoid_faces,
                 std::vector<CubeTriangle>& triangles) {
  const std::size_t n = contour.size();
  for (std::size_t i = 0; i < n; ++i) {
    const int before = contour[(i + n - 1) % n];
    const int after = contour[(i + 1) % n];
    if (n > 3 && avoid_faces && shareCubeFace(before, after)) continue;
    triangles.push_back({static_cast<std::uint8_t>(before), static_cast<std::uint8_t>(contour[i]),
                         static_cast<std::uint8_t>(after)});
    if (n == 3) return true;
    std::vector<int> rest = contour;
    rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(i));
    if (triangulate(rest, avoid_faces, triangles)) return true;
    triangles.pop_back();
  }
  return false;
}

std::vector<CubeTriangle> trianglesOfCase(int inside_mask) {
  std::vector<CubeTriangle> triangles;
  for (const CubeContour& contour : cubeContours(inside_mask)) {
    if (!triangulate(contour.edges, true, triangles)) triangulate(contour.edges, false, triangles);
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

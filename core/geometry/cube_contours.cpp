// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "core/geometry/cube_contours.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

namespace hydrabench {
namespace {

constexpr int kEdges = 12;

int edgeBetween(int a, int b) {
  for (int edge = 0; edge < kEdges; ++edge) {
    if (cubeEdgeStart(edge) == std::min(a, b) && cubeEdgeEnd(edge) == std::max(a, b)) return edge;
  }
  return -1;
}

}  // namespace

bool shareCubeFace(int edge_a, int edge_b) {
  const int corners[] = {cubeEdgeStart(edge_a), cubeEdgeEnd(edge_a), cubeEdgeStart(edge_b),
                         cubeEdgeEnd(edge_b)};
  for (int axis = 0; axis < 3; ++axis) {
    const int bit = 1 << axis;
    int set = 0;
    for (int corner : corners) set += (corner & bit) != 0 ? 1 : 0;
    if (set == 0 || set == 4) return true;
  }
  return false;
}

namespace {

void chooseFan(CubeContour& contour) {
  const std::size_t n = contour.edges.size();
  for (std::size_t turn = 0; turn < n; ++turn) {
    bool clean = true;
    for (std::size_t k = 2; k + 1 < n; ++k) {
      clean = clean && !shareCubeFace(contour.edges[0], contour.edges[k]);
    }
    if (clean) return;
    std::rotate(contour.edges.begin(), contour.edges.begin() + 1, contour.edges.end());
  }
  contour.fan_at_first = false;
}

std::vector<CubeContour> contoursOfCase(int inside_mask) {
  const auto inside = [&](int corner) { return (inside_mask >> corner & 1) != 0; };
  std::array<int, kEdges> next;
  next.fill(-1);
  for (int axis = 0; axis < 3; ++axis) {
    const int u = 1 << ((axis + 1) % 3);
    const int v = 1 << ((axis + 2) % 3);
    for (int side = 0; side < 2; ++side) {
      // The face's corners, counter-clockwise seen from outside the cube.
      const int base = side << axis;
      std::array<int, 4> ring = {base, base | u, base | u | v, base | v};
      if (side == 0) std::reverse(ring.begin(), ring.end());
      for (std::size_t i = 0; i < 4; ++i) {
        if (inside(ring[i]) || !inside(ring[(i + 1) % 4])) continue;
        std::size_t last = (i + 1) % 4;  // of the run of inside corners that starts here
        while (inside(ring[(last + 1) % 4])) last = (last + 1) % 4;
        const int entry = edgeBetween(ring[i], ring[(i + 1) % 4]);
        const int exit = edgeBetween(ring[last], ring[(last + 1) % 4]);
        next[static_cast<std::size_t>(entry)] = exit;
      }
    }
  }
  std::vector<CubeContour> contours;
  std::array<bool, kEdges> seen{};
  for (int start = 0; start < kEdges; ++start) {
    if (next[static_cast<std::size_t>(start)] < 0 || seen[static_cast<std::size_t>(start)])
      continue;
    CubeContour contour;
    for (int edge = start; !seen[static_cast<std::size_t>(edge)];
         edge = next[static_cast<std::size_t>(edge)]) {
      seen[static_cast<std::size_t>(edge)] = true;
      contour.edges.push_back(edge);
    }
    chooseFan(contour);
    contours.push_back(std::move(contour));
  }
  return contours;
}

}  // namespace

const std::vector<CubeContour>& cubeContours(int inside_mask) {
  static const std::vector<std::vector<CubeContour>> table = [] {
    std::vector<std::vector<CubeContour>> all;
    for (int mask = 0; mask < 256; ++mask) all.push_back(contoursOfCase(mask));
    return all;
  }();
  return table[static_cast<std::size_t>(inside_mask)];
}

}  // namespace hydrabench

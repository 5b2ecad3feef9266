// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "metrics/cell_block.h"
#include "metrics/voxelize.h"

namespace hydrabench {
namespace {

using Point = Eigen::Vector3d;

/// A triangle against many unit cells, by separating axes: the three axes of the cells, the
/// triangle's normal, and the nine cross products of both. The first three are dealt with by the
/// range of cells that is asked at all.
class TriangleCells {
 public:
  TriangleCells(const Point& a, const Point& b, const Point& c) : corner_(a) {
    const std::array<Point, 3> edges = {b - a, c - b, a - c};
    addAxis(edges[0].cross(edges[1]), a, b, c);
    for (const Point& edge : edges) {
      for (int axis = 0; axis < 3; ++axis) addAxis(Point::Unit(axis).cross(edge), a, b, c);
    }
  }

  bool touches(const Point& cell_low) const {
    const Point offset = cell_low - corner_;
    for (std::size_t i = 0; i < count_; ++i) {
      if (separates(axes_[i], axes_[i].direction.dot(offset))) return false;
    }
    return true;
  }

 private:
  /// Projections relative to the first corner: the triangle covers [low, high], a cell [shift +
  /// below, shift + above].
  struct Axis {
    Point direction;
    double low, high;
    double below, above;  ///< sums of the negative and of the positive components
  };

  void addAxis(const Point& direction, const Point& a, const Point& b, const Point& c) {
    if (direction.isZero(0)) return;
    const double to_b = direction.dot(b - a);
    const double to_c = direction.dot(c - a);
    const Point zero = Point::Zero();
    axes_[count_++] = {direction, std::min({0.0, to_b, to_c}), std::max({0.0, to_b, to_c}),
                       direction.cwiseMin(zero).sum(), direction.cwiseMax(zero).sum()};
  }

  /// A half-open cell lacks its upper faces: it does not reach the end of its interval where a
  /// component of the axis points there.
  static bool separates(const Axis& axis, double shift) {
    const double below = shift + axis.below;
    const double above = shift + axis.above;
    return axis.high < below || axis.low > above || (axis.high == below && axis.below < 0) ||
           (axis.low == above && axis.above > 0);
  }

  Point corner_;
  std::array<Axis, 10> axes_;
  std::size_t count_ = 0;
};

/// Marks the cells one face touches.
void markFace(const Point& a, const Point& b, const Point& c, const CellBlock& block,
              std::vector<std::uint8_t>& touched) {
  const Eigen::Array3i low = a.cwiseMin(b).cwiseMin(c).array().floor().cast<int>();
  const Eigen::Array3i high = a.cwiseMax(b).cwiseMax(c).array().floor().cast<int>();
  if (((high - low) > 0).count() <= 1) {
    // A row of cells, all touched because a face is connected. Most faces of a fine mesh end here.
    for (int x = low.x(); x <= high.x(); ++x) {
      for (int y = low.y(); y <= high.y(); ++y) {
        for (int z = low.z(); z <= high.z(); ++z) touched[block.index(x, y, z)] = 1;
      }
    }
    return;
  }
  const TriangleCells cells(a, b, c);
  for (int x = low.x(); x <= high.x(); ++x) {
    for (int y = low.y(); y <= high.y(); ++y) {
      for (int z = low.z(); z <= high.z(); ++z) {
        std::uint8_t& cell = touched[block.index(x, y, z)];
        if (!cell && cells.touches(Point(x, y, z))) cell = 1;
      }
    }
  }
}

}  // namespace

std::optional<VoxelSet> surfaceVoxels(const Mesh& mesh, const VoxelLattice& grid) {
  const std::vector<Point> vertices = inCellUnits(mesh.vertices, grid);
  const std::optional<CellBlock> block = blockAround(vertices, mesh.faces);
  if (!block) return std::nullopt;
  std::vector<std::uint8_t> touched(block->cells());
  const auto at = [&](int vertex) -> const Point& {
    return vertices[static_cast<std::size_t>(vertex)];
  };
  for (const Eigen::Vector3i& face : mesh.faces) {
    markFace(at(face[0]), at(face[1]), at(face[2]), *block, touched);
  }
  return collectRuns(*block, [&](std::size_t index) { return touched[index] != 0; });
}

}  // namespace hydrabench

// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <tuple>
#include <utility>

#include "core/geometry/winding_number.h"
#include "metrics/cell_block.h"
#include "metrics/voxelize.h"

namespace hydrabench {
namespace {

using Point = Eigen::Vector3d;

bool lessByCoordinates(const Point& a, const Point& b) {
  return std::tie(a.x(), a.y(), a.z()) < std::tie(b.x(), b.y(), b.z());
}

/// Every directed edge has as many reverses, going by positions: then the winding number is an
/// integer off the surface, and signed crossings count it. Weaker than watertight: parts may share
/// edges.
bool isBalanced(const Mesh& mesh) {
  std::vector<std::uint32_t> order(mesh.vertices.size());
  for (std::uint32_t i = 0; i < order.size(); ++i) order[i] = i;
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    return lessByCoordinates(mesh.vertices[a], mesh.vertices[b]);
  });
  std::vector<std::uint32_t> position(mesh.vertices.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    const bool same = i > 0 && mesh.vertices[order[i]] == mesh.vertices[order[i - 1]];
    position[order[i]] = same ? position[order[i - 1]] : static_cast<std::uint32_t>(i);
  }
  struct Edge {
    std::uint64_t ends;
    int direction;
  };
  std::vector<Edge> edges;
  edges.reserve(3 * mesh.faces.size());
  for (const Eigen::Vector3i& face : mesh.faces) {
    for (int corner = 0; corner < 3; ++corner) {
      const std::uint64_t a = position[static_cast<std::size_t>(face[corner])];
      const std::uint64_t b = position[static_cast<std::size_t>(face[(corner + 1) % 3])];
      if (a == b) continue;
      edges.push_back({std::min(a, b) << 32 | std::max(a, b), a < b ? 1 : -1});
    }
  }
  std::sort(edges.begin(), edges.end(),
            [](const Edge& a, const Edge& b) { return a.ends < b.ends; });
  int balance = 0;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    balance += edges[i].direction;
    if (i + 1 == edges.size() || edges[i + 1].ends != edges[i].ends) {
      if (balance != 0) return false;
    }
  }
  return !mesh.faces.empty();
}

/// x where the edge crosses the row at `y`. The lower end comes first, so both faces of an edge get
/// the same bits.
double crossingX(const Point& a, const Point& b, double y) {
  const Point& low = a.y() < b.y() ? a : b;
  const Point& high = a.y() < b.y() ? b : a;
  return low.x() + (y - low.y()) / (high.y() - low.y()) * (high.x() - low.x());
}

/// First cell (along any axis) whose centre is at or above `u`.
int firstCenter(double u) { return static_cast<int>(std::ceil(u - 0.5)); }

/// Signed crossings of the columns of cell centres with a closed surface, in cell units.
///
/// A face covers the centre (x, y) by its winding number in the plane, from half-open crossings of
/// its three edges with the ray towards +x. An edge and its reverse cancel exactly, whatever is
/// rounded, so over a closed surface the crossings of a column sum to 0: a column can never leak.
/// Crossing at height z adds its sign to all centres below z.
class ColumnCrossings {
 public:
  explicit ColumnCrossings(const CellBlock& block) : block_(block), steps_(block.cells()) {}

  void addFace(const Point& a, const Point& b, const Point& c) {
    const auto [y_min, y_max] = std::minmax({a.y(), b.y(), c.y()});
    const Point normal = (b - a).cross(c - a);
    const auto [z_min, z_max] = std::minmax({a.z(), b.z(), c.z()});
    const int y_end = firstCenter(y_max);
    for (int y = firstCenter(y_min); y < y_end; ++y) {
      const double row = y + 0.5;
      Span span;
      span.addEdge(a, b, row);
      span.addEdge(b, c, row);
      span.addEdge(c, a, row);
      const int x_end = firstCenter(span.right);
      for (int x = firstCenter(span.left); x < x_end; ++x) {
        double z =
            a.z() - (normal.x() * (x + 0.5 - a.x()) + normal.y() * (row - a.y())) / normal.z();
        z = z > z_min ? std::min(z, z_max) : z_min;  // also where the normal has no z by rounding
        addCrossing(x, y, z, span.sign);
      }
    }
  }

  VoxelSet inside() const {
    // steps_ holds changes of the winding number from the cell below; sum up the columns.
    const auto height = static_cast<std::size_t>(block_.size.z());
    int winding = 0;
    return collectRuns(block_, [&](std::size_t index) {
      if (index % height == 0) winding = 0;
      winding += steps_[index];
      return winding > 0;
    });
  }

 private:
  /// The stretch of a row that a face covers.
  struct Span {
    double left = 0;
    double right = 0;
    int sign = 0;  ///< +1: counter-clockwise seen from above, the surface faces up
    int edges = 0;

    void addEdge(const Point& from, const Point& to, double row) {
      if ((from.y() <= row) == (to.y() <= row)) return;
      const double x = crossingX(from, to, row);
      const int upward = from.y() <= row ? 1 : -1;
      if (edges++ == 0) {
        left = right = x;
        sign = upward;
      } else if (x > right) {
        right = x;
        sign = upward;
      } else {
        left = x;
      }
    }
  };

  void addCrossing(int x, int y, double z, int sign) {
    const int above = std::clamp(firstCenter(z) - block_.first.z(), 0, block_.size.z());
    const std::size_t column = block_.index(x, y, block_.first.z());
    if (above == 0) return;
    steps_[column] = static_cast<std::int16_t>(steps_[column] + sign);
    if (above < block_.size.z()) {
      std::int16_t& step = steps_[column + static_cast<std::size_t>(above)];
      step = static_cast<std::int16_t>(step - sign);
    }
  }

  CellBlock block_;
  std::vector<std::int16_t> steps_;
};

}  // namespace

struct SolidVoxelizer::Impl {
  std::vector<Point> vertices;
  std::vector<Eigen::Vector3i> faces;
  std::optional<WindingNumber> winding_number;  ///< of open meshes

  VoxelSet byCrossings(const std::vector<Point>& cell_vertices, const CellBlock& block) const {
    ColumnCrossings crossings(block);
    const auto at = [&](int vertex) { return cell_vertices[static_cast<std::size_t>(vertex)]; };
    for (const Eigen::Vector3i& face : faces) {
      crossings.addFace(at(face[0]), at(face[1]), at(face[2]));
    }
    return crossings.inside();
  }
};

namespace {

/// The cells of a block whose centres satisfy is_inside(centre in the world).
template <typename IsInside>
VoxelSet byCenters(const CellBlock& block, const VoxelLattice& grid, const IsInside& is_inside) {
  const auto height = static_cast<std::size_t>(block.size.z());
  const auto depth = static_cast<std::size_t>(block.size.y());
  return collectRuns(block, [&](std::size_t index) {
    const Eigen::Array3i cell =
        block.first + Eigen::Array3i(static_cast<int>(index / height / depth),
                                     static_cast<int>(index / height % depth),
                                     static_cast<int>(index % height));
    return is_inside(Point(grid.origin + grid.pitch_m * (cell.cast<double>() + 0.5).matrix()));
  });
}

}  // namespace

SolidVoxelizer::SolidVoxelizer(const Mesh& mesh) : impl_(std::make_unique<Impl>()) {
  impl_->vertices = mesh.vertices;
  impl_->faces = mesh.faces;
  if (mesh.empty()) return;
  if (!isBalanced(mesh)) {
    impl_->winding_number.emplace(mesh);
  } else if (signedVolume(mesh) < 0) {
    for (Eigen::Vector3i& face : impl_->faces) std::swap(face[1], face[2]);
  }
}
SolidVoxelizer::~SolidVoxelizer() = default;
SolidVoxelizer::SolidVoxelizer(SolidVoxelizer&&) noexcept = default;
SolidVoxelizer& SolidVoxelizer::operator=(SolidVoxelizer&&) noexcept = default;

bool SolidVoxelizer::countsCrossings() const {
  return !impl_->faces.empty() && !impl_->winding_number;
}

std::optional<VoxelSet> SolidVoxelizer::voxelize(const VoxelLattice& grid) const {
  const std::vector<Point> cell_vertices = inCellUnits(impl_->vertices, grid);
  const std::optional<CellBlock> block = blockAround(cell_vertices, impl_->faces);
  if (!block) return std::nullopt;
  if (block->cells() == 0) return VoxelSet();
  if (countsCrossings()) return impl_->byCrossings(cell_vertices, *block);
  return byCenters(*block, grid,
                   [&](const Point& center) { return impl_->winding_number->at(center) > 0.5; });
}

VoxelSet solidVoxelsReference(const Mesh& mesh, const VoxelLattice& grid) {
  const std::optional<CellBlock> block = blockAround(inCellUnits(mesh.vertices, grid), mesh.faces);
  if (!block || block->cells() == 0) return VoxelSet();
  const WindingNumber winding_number(mesh);
  return byCenters(*block, grid,
                   [&](const Point& center) { return winding_number.exactAt(center) > 0.5; });
}

}  // namespace hydrabench

// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "core/shape/sdf_mesher.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "core/geometry/cube_contours.h"
#include "core/geometry/cube_triangles.h"
#include "core/geometry/mesh_topology.h"
#include "core/parallel/parallel_for.h"

namespace hydrabench {
namespace {

using Eigen::Vector3i;

constexpr std::size_t kBatch = 2048;  ///< points per call of the field
constexpr int kUnknown = -1;

Vector3i cornerOffset(int corner) { return {corner & 1, corner >> 1 & 1, corner >> 2 & 1}; }

/// Values of the field at the points of the finest grid, as far as they have been asked for.
class Lattice {
 public:
  Lattice(const SdfField& field, const SdfMesherConfig& config)
      : field_(field),
        points_(config.resolution + 1),
        half_side_(config.half_side),
        pitch_(2 * config.half_side / config.resolution),
        level_(static_cast<float>(config.level)),
        slots_(cube(points_), kUnknown) {}

  double pitch() const { return pitch_; }
  Eigen::Vector3d position(const Vector3i& point) const {
    return pitch_ * point.cast<double>().array() - half_side_;
  }
  /// Where the value of a point is kept; kUnknown before it is evaluated.
  int slot(const Vector3i& point) const { return slots_[index(point)]; }
  float value(const Vector3i& point) const {
    return values_[static_cast<std::size_t>(slot(point))];
  }
  std::size_t evaluated() const { return values_.size(); }

  /// Asks the field at those of the points that are not known; the level counts as 0. False where a
  /// value is not finite.
  bool evaluate(const std::vector<Vector3i>& points) {
    std::vector<Eigen::Vector3f> asked;
    const std::size_t first = values_.size();
    for (const Vector3i& point : points) {
      int& slot = slots_[index(point)];
      if (slot != kUnknown) continue;
      slot = static_cast<int>(first + asked.size());
      asked.push_back(position(point).cast<float>());
    }
    values_.resize(first + asked.size());
    parallelForRanges(asked.size(), kBatch, [&](std::size_t begin, std::size_t end) {
      field_(std::span(asked).subspan(begin, end - begin),
             std::span(values_).subspan(first + begin, end - begin));
      for (std::size_t i = first + begin; i < first + end; ++i) values_[i] -= level_;
    });
    return std::all_of(values_.begin() + static_cast<std::ptrdiff_t>(first), values_.end(),
                       [](float value) { return std::isfinite(value); });
  }
  bool evaluateCorners(const std::vector<Vector3i>& cells, int size) {
    std::vector<Vector3i> corners;
    corners.reserve(8 * cells.size());
    for (const Vector3i& cell : cells) {
      for (int c = 0; c < 8; ++c) corners.push_back(cell + size * cornerOffset(c));
    }
    return evaluate(corners);
  }

 private:
  static std::size_t cube(int n) {
    return static_cast<std::size_t>(n) * static_cast<std::size_t>(n) * static_cast<std::size_t>(n);
  }
  std::size_t index(const Vector3i& p) const {
    const auto n = static_cast<std::size_t>(points_);
    return (static_cast<std::size_t>(p.z()) * n + static_cast<std::size_t>(p.y())) * n +
           static_cast<std::size_t>(p.x());
  }

  const SdfField& field_;
  int points_;  ///< along a side
  double half_side_;
  double pitch_;
  float level_;
  std::vector<int> slots_;
  std::vector<float> values_;
};

/// A cell of the finest grid that the surface passes through.
struct CutCell {
  Vector3i cell;
  int inside_mask;
};

class Mesher {
 public:
  Mesher(const SdfField& field, const SdfMesherConfig& config)
      : config_(config), lattice_(field, config) {}

  std::optional<Mesh> run() {
    const int n = config_.resolution;
    int size = n / config_.coarse_resolution;
    std::vector<Vector3i> cells;
    for (int z = 0; z < n; z += size) {
      for (int y = 0; y < n; y += size) {
        for (int x = 0; x < n; x += size) cells.emplace_back(x, y, z);
      }
    }
    if (!lattice_.evaluateCorners(cells, size)) return std::nullopt;
    for (; size > 1; size /= 2) {
      if (!refine(cells, size)) return std::nullopt;
    }
    const std::optional<std::vector<CutCell>> cut = followSurface(cells);
    if (!cut || cut->empty()) return std::nullopt;
    triangulate(*cut);
    return largePieces();
  }

 private:
  /// Bit c: corner c is inside.
  int insideMask(const Vector3i& cell, int size) const {
    int mask = 0;
    for (int c = 0; c < 8; ++c) {
      if (lattice_.value(cell + size * cornerOffset(c)) < 0) mask |= 1 << c;
    }
    return mask;
  }
  static bool isCut(int mask) { return mask != 0 && mask != 255; }

  /// Replaces cells by the children of those that the surface passes through, or may. On the last
  /// level, where following the surface finds what hangs together, "may" needs a centre that lies
  /// on the other side than the corners: enough for a sheet thinner than a cell.
  bool refine(std::vector<Vector3i>& cells, int size) {
    std::vector<Vector3i> refined;
    std::vector<Vector3i> near;
    for (const Vector3i& cell : cells) {
      if (isCut(insideMask(cell, size))) {
        refined.push_back(cell);
      } else if (isNear(cell, size)) {
        near.push_back(cell);
      }
    }
    if (size == 2) {
      std::vector<Vector3i> centers = near;
      for (Vector3i& center : centers) center += Vector3i::Ones();
      if (!lattice_.evaluate(centers)) return false;
      std::erase_if(near, [&](const Vector3i& cell) {
        return (lattice_.value(cell) < 0) == (lattice_.value(cell + Vector3i::Ones()) < 0);
      });
    }
    refined.insert(refined.end(), near.begin(), near.end());
    cells.clear();
    for (const Vector3i& cell : refined) {
      for (int c = 0; c < 8; ++c) cells.push_back(cell + size / 2 * cornerOffset(c));
    }
    return lattice_.evaluateCorners(cells, size / 2);
  }
  bool isNear(const Vector3i& cell, int size) const {
    const auto reach =
        static_cast<float>(config_.refine_margin * 0.5 * std::sqrt(3.0) * size * lattice_.pitch());
    for (int c = 0; c < 8; ++c) {
      if (std::abs(lattice_.value(cell + size * cornerOffset(c))) < reach) return true;
    }
    return false;
  }

  /// The cut cells among those given, those that the surface enters from there, and so on. nullopt
  /// where a value is not finite.
  std::optional<std::vector<CutCell>> followSurface(std::vector<Vector3i> cells) {
    const int n = config_.resolution;
    const auto index = [n](const Vector3i& cell) {
      return static_cast<std::size_t>((cell.z() * n + cell.y()) * n + cell.x());
    };
    std::vector<char> seen(index(Vector3i(0, 0, n)), 0);
    for (const Vector3i& cell : cells) seen[index(cell)] = 1;
    std::vector<CutCell> cut;
    while (!cells.empty()) {
      std::vector<Vector3i> entered;
      for (const Vector3i& cell : cells) {
        const int mask = insideMask(cell, 1);
        if (!isCut(mask)) continue;
        cut.push_back({cell, mask});
        for (int face = 0; face < 6; ++face) {
          const int axis = face / 2;
          Vector3i neighbor = cell;
          neighbor[axis] += face % 2 == 0 ? -1 : 1;
          if (neighbor[axis] < 0 || neighbor[axis] >= n || !cutsFace(mask, face)) continue;
          if (std::exchange(seen[index(neighbor)], 1) == 0) entered.push_back(neighbor);
        }
      }
      if (!lattice_.evaluateCorners(entered, 1)) return std::nullopt;
      cells = std::move(entered);
    }
    return cut;
  }
  /// Faces in the order -x, +x, -y, +y, -z, +z.
  static bool cutsFace(int mask, int face) {
    constexpr std::array<int, 6> kCorners = {0x55, 0xaa, 0x33, 0xcc, 0x0f, 0xf0};
    const int corners = kCorners[static_cast<std::size_t>(face)];
    return (mask & corners) != 0 && (mask & corners) != corners;
  }

  Mesh largePieces() const {
    std::vector<Mesh> pieces = connectedComponents(mesh_);
    Mesh kept = std::move(pieces.front());
    if (config_.min_piece_share >= 1) return kept;  // of two that are equal, one
    const double enough = config_.min_piece_share * surfaceArea(kept);
    for (std::size_t i = 1; i < pieces.size() && surfaceArea(pieces[i]) >= enough; ++i) {
      append(pieces[i], kept);
    }
    return kept;
  }

  void triangulate(const std::vector<CutCell>& cut) {
    vertex_of_edge_.assign(3 * lattice_.evaluated(), kUnknown);
    for (const auto& [cell, inside_mask] : cut) {
      for (const CubeTriangle& triangle : cubeTriangles(inside_mask)) {
        mesh_.faces.emplace_back(vertexOn(cell, triangle[0]), vertexOn(cell, triangle[1]),
                                 vertexOn(cell, triangle[2]));
      }
    }
  }

  int vertexOn(const Vector3i& cell, int edge) {
    const Vector3i start = cell + cornerOffset(cubeEdgeStart(edge));
    const int axis = edge / 4;
    int& vertex = vertex_of_edge_[static_cast<std::size_t>(3 * lattice_.slot(start) + axis)];
    if (vertex != kUnknown) return vertex;
    vertex = static_cast<int>(mesh_.vertices.size());
    const double a = lattice_.value(start);
    const double b = lattice_.value(start + Vector3i::Unit(axis));
    Eigen::Vector3d position = lattice_.position(start);
    // Off the corners, so that vertices of different edges never share a position.
    position[axis] += std::clamp(a / (a - b), 1e-3, 1 - 1e-3) * lattice_.pitch();
    mesh_.vertices.push_back(position);
    return vertex;
  }

  const SdfMesherConfig& config_;
  Lattice lattice_;
  std::vector<int> vertex_of_edge_;  ///< three edges per evaluated point, towards +x, +y, +z
  Mesh mesh_;
};

bool isPowerOfTwo(int n) { return n > 0 && std::has_single_bit(static_cast<unsigned>(n)); }

}  // namespace

void read(ConfigReader& reader, SdfMesherConfig& config) {
  reader.field("resolution", config.resolution, Bounds{4, 512});
  reader.field("coarse_resolution", config.coarse_resolution, Bounds{2, 512});
  reader.field("refine_margin", config.refine_margin, Bounds{0, 10});
  reader.field("level", config.level, Bounds{-1, 1});
  reader.field("min_piece_share", config.min_piece_share, Bounds{0, 1});
  if (!isPowerOfTwo(config.resolution)) reader.fault("resolution", "expected a power of two");
  if (!isPowerOfTwo(config.coarse_resolution) || config.coarse_resolution > config.resolution) {
    reader.fault("coarse_resolution", "expected a power of two, at most the resolution");
  }
}

std::optional<Mesh> meshLevelSet(const SdfField& field, const SdfMesherConfig& config) {
  assert(config.half_side > 0 && isPowerOfTwo(config.resolution));
  assert(isPowerOfTwo(config.coarse_resolution) && config.coarse_resolution <= config.resolution);
  return Mesher(field, config).run();
}

}  // namespace hydrabench

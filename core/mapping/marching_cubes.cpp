// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "core/mapping/marching_cubes.h"

#include <array>
#include <bit>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "core/geometry/cube_contours.h"
#include "core/geometry/cube_triangles.h"

namespace hydrabench {
namespace {

constexpr float kEqualDistances = 1e-6f;  // below, the surface is put half way (Hydra)

using Row = std::uint64_t;  // one bit per voxel along x

struct Corner {
  const VoxelBlock* block = nullptr;
  std::size_t local = 0;
  const TsdfVoxel& voxel() const { return block->voxels[local]; }
};

/// A block with those at +x, +y, +z, seen as one grid of (side + 1)^3 voxels.
class BlockWithNeighbors {
 public:
  BlockWithNeighbors(const TsdfVolume& volume, const BlockIndex& block)
      : grid_(volume.grid()), side_(grid_.side) {
    assert(side_ < 64);
    for (int n = 0; n < 8; ++n) {
      blocks_[static_cast<std::size_t>(n)] =
          volume.find(block + Eigen::Vector3i(n & 1, n >> 1 & 1, n >> 2 & 1));
    }
  }
  bool exists() const { return blocks_[0] != nullptr; }

  /// The block is null where a neighbour is missing.
  Corner corner(int x, int y, int z) const {
    const int n = (x == side_ ? 1 : 0) | (y == side_ ? 2 : 0) | (z == side_ ? 4 : 0);
    return {blocks_[static_cast<std::size_t>(n)],
            grid_.localIndex(x == side_ ? 0 : x, y == side_ ? 0 : y, z == side_ ? 0 : z)};
  }

 private:
  const VoxelGrid& grid_;
  int side_;
  std::array<const VoxelBlock*, 8> blocks_;
};

/// Which voxels are measured and which of these are inside, a bit each: whole rows of cubes without
/// surface are passed over by a few operations on words.
class SignRows {
 public:
  SignRows(const BlockWithNeighbors& blocks, int side, float min_weight)
      : width_(static_cast<std::size_t>(side) + 1),
        measured_(width_ * width_, 0),
        negative_(width_ * width_, 0) {
    for (int z = 0; z <= side; ++z) {
      for (int y = 0; y <= side; ++y) {
        Row& measured = measured_[index(y, z)];
        Row& negative = negative_[index(y, z)];
        const Corner first = blocks.corner(0, y, z);
        if (first.block) {
          const TsdfVoxel* voxels = &first.voxel();
          for (int x = 0; x < side; ++x) add(voxels[x], x, min_weight, measured, negative);
        }
        const Corner last = blocks.corner(side, y, z);
        if (last.block) add(last.voxel(), side, min_weight, measured, negative);
        any_negative_ = any_negative_ || (measured & negative) != 0;
        any_positive_ = any_positive_ || (measured & ~negative) != 0;
      }
    }
  }
  bool surfacePossible() const { return any_negative_ && any_positive_; }

  /// Bit x: the cube at (x, y, z) has eight measured corners and the surface passes through.
  Row cutCubes(int y, int z) const {
    const std::size_t r[] = {index(y, z), index(y + 1, z), index(y, z + 1), index(y + 1, z + 1)};
    Row measured = measured_[r[0]] & measured_[r[1]] & measured_[r[2]] & measured_[r[3]];
    Row any = negative_[r[0]] | negative_[r[1]] | negative_[r[2]] | negative_[r[3]];
    Row all = negative_[r[0]] & negative_[r[1]] & negative_[r[2]] & negative_[r[3]];
    measured &= measured >> 1;
    any |= any >> 1;
    all &= all >> 1;
    return measured & any & ~all;
  }
  int insideMask(int x, int y, int z) const {
    const auto pair = [&](int dy, int dz) {
      return static_cast<int>(negative_[index(y + dy, z + dz)] >> x & 3);
    };
    return pair(0, 0) | pair(1, 0) << 2 | pair(0, 1) << 4 | pair(1, 1) << 6;
  }

 private:
  std::size_t index(int y, int z) const {
    return static_cast<std::size_t>(z) * width_ + static_cast<std::size_t>(y);
  }
  static void add(const TsdfVoxel& voxel, int x, float min_weight, Row& measured, Row& negative) {
    const bool known = voxel.weight >= min_weight && voxel.weight > 0;
    measured |= static_cast<Row>(known) << x;
    negative |= static_cast<Row>(voxel.distance < 0) << x;
  }

  std::size_t width_;
  std::vector<Row> measured_;
  std::vector<Row> negative_;
  bool any_negative_ = false;
  bool any_positive_ = false;
};

Rgb blend(const TsdfVoxel& a, const TsdfVoxel& b, double t) {
  if (!a.colored || !b.colored) return a.colored ? a.color : b.color;
  const auto mix = [t](std::uint8_t from, std::uint8_t to) {
    return static_cast<std::uint8_t>(std::lround(from + t * (static_cast<double>(to) - from)));
  };
  return {mix(a.color.r, b.color.r), mix(a.color.g, b.color.g), mix(a.color.b, b.color.b)};
}

Label labelOf(const Corner& corner) {
  if (!corner.block->semantics) return kUnknownLabel;
  return corner.block->semantics->label(corner.local).value_or(kUnknownLabel);
}

struct CutPoint {
  Eigen::Vector3d position;
  Rgb color;
  Label label = kUnknownLabel;
};

/// @param low_center  centre of the lower of the two voxels [m]
CutPoint cut(const Corner& low, const Corner& high, int axis, const Eigen::Vector3d& low_center,
             double voxel_size) {
  const TsdfVoxel& a = low.voxel();
  const TsdfVoxel& b = high.voxel();
  const float difference = a.distance - b.distance;
  const double t = std::abs(difference) <= kEqualDistances
                       ? 0.5
                       : static_cast<double>(a.distance) / static_cast<double>(difference);
  CutPoint point;
  point.position = low_center;
  point.position[axis] += t * voxel_size;
  point.color = blend(a, b, t);
  const bool low_is_nearer = t < 0.5 || (t == 0.5 && a.weight >= b.weight);
  point.label = labelOf(low_is_nearer ? low : high);
  return point;
}

}  // namespace

TriangleSoup marchingCubes(const TsdfVolume& volume, const BlockIndex& block, double min_weight) {
  TriangleSoup soup;
  const VoxelGrid& grid = volume.grid();
  const BlockWithNeighbors blocks(volume, block);
  if (!blocks.exists()) return soup;
  // As a float, so that a voxel of exactly this weight counts.
  const SignRows signs(blocks, grid.side, static_cast<float>(min_weight));
  if (!signs.surfacePossible()) return soup;

  std::array<CutPoint, 12> cuts;
  for (int z = 0; z < grid.side; ++z) {
    for (int y = 0; y < grid.side; ++y) {
      for (Row cubes = signs.cutCubes(y, z); cubes != 0; cubes &= cubes - 1) {
        const int x = std::countr_zero(cubes);
        const int inside = signs.insideMask(x, y, z);
        const auto cornerOfCube = [&](int c) {
          return blocks.corner(x + (c & 1), y + (c >> 1 & 1), z + (c >> 2 & 1));
        };
        for (int edge = 0; edge < 12; ++edge) {
          const int low = cubeEdgeStart(edge);
          const int high = cubeEdgeEnd(edge);
          if (((inside >> low ^ inside >> high) & 1) == 0) continue;
          const GlobalVoxel voxel =
              grid.side * block +
              Eigen::Vector3i(x + (low & 1), y + (low >> 1 & 1), z + (low >> 2 & 1));
          cuts[static_cast<std::size_t>(edge)] =
              cut(cornerOfCube(low), cornerOfCube(high), edge / 4, grid.centerOf(voxel),
                  grid.voxel_size);
        }
        for (const CubeTriangle& triangle : cubeTriangles(inside)) {
          for (std::uint8_t edge : triangle) {
            soup.vertices.push_back(cuts[edge].position);
            soup.colors.push_back(cuts[edge].color);
            soup.labels.push_back(cuts[edge].label);
          }
        }
      }
    }
  }
  return soup;
}

}  // namespace hydrabench

// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "baselines/hydra/mesh_clustering.h"

#include <cassert>
#include <cstddef>
#include <numeric>

#include "core/mapping/cell_table.h"
#include "core/mapping/voxel_grid.h"

namespace hydrabench {
namespace {

struct Cell {
  GlobalVoxel index;
  std::vector<std::uint32_t> points;
};

/// Cells that are known to belong together.
class CellSets {
 public:
  explicit CellSets(std::size_t count) : parent_(count) {
    std::iota(parent_.begin(), parent_.end(), 0u);
  }
  std::uint32_t find(std::uint32_t cell) {
    while (parent_[cell] != cell) cell = parent_[cell] = parent_[parent_[cell]];
    return cell;
  }
  void join(std::uint32_t a, std::uint32_t b) { parent_[find(b)] = find(a); }

 private:
  std::vector<std::uint32_t> parent_;
};

/// Half of the cells that a step of two cell sizes can reach; the other half finds this one.
std::vector<GlobalVoxel> reachableOffsets() {
  std::vector<GlobalVoxel> offsets;
  for (int x = -2; x <= 2; ++x) {
    for (int y = -2; y <= 2; ++y) {
      for (int z = -2; z <= 2; ++z) {
        const GlobalVoxel offset(x, y, z);
        if (IndexLess()(GlobalVoxel(0, 0, 0), offset)) offsets.push_back(offset);
      }
    }
  }
  return offsets;
}

bool touch(const Cell& a, const Cell& b, std::span<const Eigen::Vector3d> points, double radius) {
  for (const std::uint32_t i : a.points) {
    for (const std::uint32_t j : b.points) {
      if ((points[i] - points[j]).squaredNorm() <= radius * radius) return true;
    }
  }
  return false;
}

}  // namespace

std::vector<std::vector<std::uint32_t>> euclideanClusters(std::span<const Eigen::Vector3d> points,
                                                          double radius) {
  assert(radius > 0);
  std::vector<Cell> cells;
  std::vector<std::uint32_t> cell_of_point(points.size());
  CellTable table;
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    const GlobalVoxel index = floored(points[i] * (2 / radius));
    std::uint32_t& cell = table.findOrAdd(index);
    if (cell == CellTable::kNone) {
      cell = static_cast<std::uint32_t>(cells.size());
      cells.push_back({index, {}});
    }
    cells[cell].points.push_back(i);
    cell_of_point[i] = cell;
  }

  CellSets sets(cells.size());
  const std::vector<GlobalVoxel> offsets = reachableOffsets();
  for (std::uint32_t a = 0; a < cells.size(); ++a) {
    for (const GlobalVoxel& offset : offsets) {
      const std::uint32_t b = table.find(cells[a].index + offset);
      if (b == CellTable::kNone || sets.find(a) == sets.find(b)) continue;
      if (touch(cells[a], cells[b], points, radius)) sets.join(a, b);
    }
  }

  std::vector<std::vector<std::uint32_t>> clusters;
  std::vector<std::uint32_t> cluster_of_set(cells.size(), CellTable::kNone);
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    std::uint32_t& cluster = cluster_of_set[sets.find(cell_of_point[i])];
    if (cluster == CellTable::kNone) {
      cluster = static_cast<std::uint32_t>(clusters.size());
      clusters.emplace_back();
    }
    clusters[cluster].push_back(i);
  }
  return clusters;
}

}  // namespace hydrabench

// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "metrics/voxel_set.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <tuple>

#include "core/types/random.h"

namespace hydrabench {
namespace {

auto columnOf(const VoxelSet::Run& run) { return std::tie(run.x, run.y); }

}  // namespace

std::vector<VoxelLattice> jitteredGrids(const VoxelLattice& grid, std::size_t count,
                                        std::uint64_t seed) {
  std::vector<VoxelLattice> grids = {grid};
  for (std::size_t i = 0; i < count; ++i) {
    Random random(seed, i);
    VoxelLattice moved = grid;
    for (double& coordinate : moved.origin) coordinate += grid.pitch_m * random.uniform();
    grids.push_back(moved);
  }
  return grids;
}

VoxelSet::VoxelSet(std::vector<Run> runs) : runs_(std::move(runs)) {
  for (std::size_t i = 0; i < runs_.size(); ++i) {
    assert(runs_[i].z_begin < runs_[i].z_end);
    assert(i == 0 || columnOf(runs_[i - 1]) < columnOf(runs_[i]) ||
           (columnOf(runs_[i - 1]) == columnOf(runs_[i]) && runs_[i - 1].z_end < runs_[i].z_begin));
    count_ += static_cast<std::size_t>(runs_[i].z_end - runs_[i].z_begin);
  }
}

bool VoxelSet::contains(int x, int y, int z) const {
  const auto after = std::upper_bound(runs_.begin(), runs_.end(), std::tuple(x, y, z),
                                      [](const std::tuple<int, int, int>& cell, const Run& run) {
                                        return cell < std::tie(run.x, run.y, run.z_begin);
                                      });
  if (after == runs_.begin()) return false;
  const Run& run = *std::prev(after);
  return run.x == x && run.y == y && z < run.z_end;
}

std::size_t intersectionCount(const VoxelSet& a, const VoxelSet& b) {
  std::size_t count = 0;
  auto i = a.runs().begin();
  auto j = b.runs().begin();
  while (i != a.runs().end() && j != b.runs().end()) {
    if (columnOf(*i) != columnOf(*j)) {
      columnOf(*i) < columnOf(*j) ? ++i : ++j;
      continue;
    }
    const int overlap = std::min(i->z_end, j->z_end) - std::max(i->z_begin, j->z_begin);
    if (overlap > 0) count += static_cast<std::size_t>(overlap);
    i->z_end < j->z_end ? ++i : ++j;
  }
  return count;
}

std::optional<double> voxelIou(const VoxelSet& a, const VoxelSet& b) {
  const std::size_t shared = intersectionCount(a, b);
  const std::size_t either = a.count() + b.count() - shared;
  if (either == 0) return std::nullopt;
  return static_cast<double>(shared) / static_cast<double>(either);
}

std::optional<OriginSpread> originSpread(std::span<const std::optional<double>> values) {
  if (values.empty()) return std::nullopt;
  OriginSpread spread{0, 0, std::numeric_limits<double>::infinity(), 0};
  for (const std::optional<double>& value : values) {
    if (!value) return std::nullopt;
    spread.mean += *value / static_cast<double>(values.size());
    spread.min = std::min(spread.min, *value);
    spread.max = std::max(spread.max, *value);
  }
  if (spread.min == spread.max) spread.mean = spread.min;  // no rounding where nothing spreads
  double squared = 0;
  for (const std::optional<double>& value : values) {
    squared += (*value - spread.mean) * (*value - spread.mean);
  }
  spread.deviation = std::sqrt(squared / static_cast<double>(values.size()));
  return spread;
}

}  // namespace hydrabench

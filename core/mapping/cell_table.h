// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "core/mapping/voxel_grid.h"

namespace hydrabench {

/// From cells of a grid to numbers: open addressing in one array, at most half full, without
/// tombstones.
class CellTable {
 public:
  static constexpr std::uint32_t kNone = 0xffffffff;

  CellTable() : entries_(64) {}

  std::size_t size() const { return size_; }

  /// The number of a cell, kNone where it is not there.
  std::uint32_t find(const Eigen::Vector3i& cell) const { return entries_[placeOf(cell)].value; }

  /// The number of a cell, kNone for a new one: whoever asked then sets it. Valid until the next
  /// call.
  std::uint32_t& findOrAdd(const Eigen::Vector3i& cell) {
    if (2 * (size_ + 1) > entries_.size()) grow();
    const std::size_t i = placeOf(cell);
    if (entries_[i].value == kNone) {
      entries_[i].cell = cell;
      ++size_;
    }
    return entries_[i].value;
  }

  /// The cell must be there.
  void erase(const Eigen::Vector3i& cell) {
    std::size_t hole = placeOf(cell);
    // What follows in the run moves up where the hole lies between its home and its place.
    for (std::size_t i = next(hole); entries_[i].value != kNone; i = next(i)) {
      if (distance(home(entries_[i].cell), i) < distance(hole, i)) continue;
      entries_[hole] = entries_[i];
      hole = i;
    }
    entries_[hole] = {};
    --size_;
  }

 private:
  struct Entry {
    Eigen::Vector3i cell = Eigen::Vector3i::Zero();
    std::uint32_t value = kNone;
  };
  std::size_t home(const Eigen::Vector3i& cell) const {
    return IndexHash()(cell) & (entries_.size() - 1);
  }
  /// Where it is, or would be put.
  std::size_t placeOf(const Eigen::Vector3i& cell) const {
    std::size_t i = home(cell);
    while (entries_[i].value != kNone && entries_[i].cell != cell) i = next(i);
    return i;
  }
  std::size_t next(std::size_t i) const { return (i + 1) & (entries_.size() - 1); }
  std::size_t distance(std::size_t from, std::size_t to) const {
    return (to - from) & (entries_.size() - 1);
  }
  void grow() {
    std::vector<Entry> old(2 * entries_.size());
    old.swap(entries_);
    for (const Entry& entry : old) {
      if (entry.value == kNone) continue;
      entries_[placeOf(entry.cell)] = entry;
    }
  }

  std::vector<Entry> entries_;
  std::size_t size_ = 0;
};

}  // namespace hydrabench

// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "core/objects/pixel_groups.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cassert>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "core/mapping/voxel_grid.h"
#include "core/parallel/parallel_for.h"

namespace hydrabench {
namespace {

constexpr std::size_t kRowsPerTask = 16;

/// Neighbouring pixels of a row with one key, of which 0 is none.
struct Run {
  std::uint32_t begin = 0;
  std::uint32_t end = 0;
  std::uint64_t key = 0;
};

/// Runs of equal keys in row-major order.
/// @param key  of a usable pixel, given its column, row and kind; not 0
template <typename Key>
std::vector<Run> findRuns(const PixelSelection& selection, const Key& key) {
  const Image<std::int32_t>& values = selection.values;
  const Image<float>& range = selection.view.range;
  assert(values.size() == range.size());
  const auto max_range = static_cast<float>(selection.max_range_m);
  const auto height = static_cast<std::size_t>(values.height());
  const auto width = static_cast<std::size_t>(values.width());

  std::vector<std::vector<Run>> parts((height + kRowsPerTask - 1) / kRowsPerTask);
  parallelFor(parts.size(), [&](std::size_t part) {
    std::vector<Run>& runs = parts[part];
    for (std::size_t v = part * kRowsPerTask; v < std::min(height, (part + 1) * kRowsPerTask);
         ++v) {
      std::int32_t last_value = 0;
      std::size_t kind = selection.kind(0);
      Run run;
      const auto close = [&] {
        if (run.key != 0) runs.push_back(run);
        run.key = 0;
      };
      for (std::size_t u = 0; u < width; ++u) {
        const std::size_t i = v * width + u;
        if (values.data()[i] != last_value) {
          last_value = values.data()[i];
          kind = selection.kind(last_value);
        }
        const float r = range.data()[i];
        const bool usable = kind != 0 && r > 0 && r <= max_range &&
                            !(selection.moving && selection.moving->data()[i] != 0);
        if (!usable) {
          close();
          continue;
        }
        const auto pixel = static_cast<std::uint32_t>(i);
        const std::uint64_t pixel_key = key(u, v, kind);
        if (pixel_key != run.key) {
          close();
          run = {pixel, pixel, pixel_key};
        }
        run.end = pixel + 1;
      }
      close();
    }
  });

  std::vector<Run> runs;
  for (const std::vector<Run>& part : parts) runs.insert(runs.end(), part.begin(), part.end());
  return runs;
}

/// Numbers keys in order of first appearance.
class KeyTable {
 public:
  explicit KeyTable(std::size_t max_keys)
      : slots_(std::bit_ceil(2 * max_keys + 2)), mask_(slots_.size() - 1) {}

  std::uint32_t add(std::uint64_t key) {
    Slot& slot = slots_[probe(key)];
    if (slot.key == 0) {
      slot = {key, static_cast<std::uint32_t>(keys_.size())};
      keys_.push_back(key);
    }
    return slot.number;
  }
  /// nullptr where the key was not added.
  const std::uint32_t* find(std::uint64_t key) const {
    const Slot& slot = slots_[probe(key)];
    return slot.key == 0 ? nullptr : &slot.number;
  }
  const std::vector<std::uint64_t>& keys() const { return keys_; }

 private:
  struct Slot {
    std::uint64_t key = 0;
    std::uint32_t number = 0;
  };
  std::size_t probe(std::uint64_t key) const {
    std::size_t at = static_cast<std::size_t>((key * 0x9e3779b97f4a7c15ull) >> 20) & mask_;
    while (slots_[at].key != 0 && slots_[at].key != key) at = (at + 1) & mask_;
    return at;
  }
  std::vector<Slot> slots_;
  std::size_t mask_;
  std::vector<std::uint64_t> keys_;
};

std::uint32_t rootOf(std::vector<std::uint32_t>& parents, std::uint32_t i) {
  while (parents[i] != i) i = parents[i] = parents[parents[i]];
  return i;
}

// Key of a cell: kind in the top bits, then 18 bits per axis, counted from the sensor's cell in
// the middle of their range; so a neighbour's key is a sum.
constexpr int kAxisBits = 18;
constexpr std::int64_t kMiddle = std::int64_t{1} << (kAxisBits - 1);

std::uint64_t cellKey(std::size_t kind, const Eigen::Vector3i& cell) {
  std::uint64_t key = kind;
  for (int axis = 0; axis < 3; ++axis) {
    assert(std::abs(cell[axis]) < kMiddle - 1);
    key = key << kAxisBits | static_cast<std::uint64_t>(kMiddle + cell[axis]);
  }
  return key;
}

/// The half of the 26 neighbours that comes after a cell; the other half is met from there.
std::array<std::uint64_t, 13> laterNeighbors() {
  std::array<std::uint64_t, 13> offsets{};
  std::size_t count = 0;
  for (std::int64_t x = -1; x <= 1; ++x) {
    for (std::int64_t y = -1; y <= 1; ++y) {
      for (std::int64_t z = -1; z <= 1; ++z) {
        const std::int64_t offset = (x * (1 << kAxisBits) + y) * (1 << kAxisBits) + z;
        if (offset > 0) offsets[count++] = static_cast<std::uint64_t>(offset);
      }
    }
  }
  return offsets;
}

/// Joins runs of which `group` gives one number.
template <typename Group>
std::vector<PixelGroup> gather(const std::vector<Run>& runs, const Group& group,
                               std::size_t max_groups) {
  constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();
  std::vector<std::uint32_t> numbers(max_groups, kNone);
  std::vector<PixelGroup> groups;
  for (std::size_t r = 0; r < runs.size(); ++r) {
    const auto [id, kind] = group(r);
    if (numbers[id] == kNone) {
      numbers[id] = static_cast<std::uint32_t>(groups.size());
      groups.push_back({kind, {}});
    }
    std::vector<std::uint32_t>& pixels = groups[numbers[id]].pixels;
    for (std::uint32_t pixel = runs[r].begin; pixel < runs[r].end; ++pixel) pixels.push_back(pixel);
  }
  return groups;
}

}  // namespace

PixelPoints::PixelPoints(const SensorView& view)
    : range_(view.range.data()),
      x_(static_cast<std::size_t>(view.range.width())),
      y_(static_cast<std::size_t>(view.range.height())),
      origin_(view.T_world_sensor.translation()),
      axis_x_(view.T_world_sensor.linear().col(0)),
      axis_y_(view.T_world_sensor.linear().col(1)),
      axis_z_(view.T_world_sensor.linear().col(2)) {
  const Camera& camera = view.camera;
  for (std::size_t u = 0; u < x_.size(); ++u) {
    x_[u] = camera.backproject(static_cast<double>(u), 0, 1).x();
  }
  for (std::size_t v = 0; v < y_.size(); ++v) {
    y_[v] = camera.backproject(0, static_cast<double>(v), 1).y();
  }
}

std::vector<PixelGroup> groupsByKind(const PixelSelection& selection, std::size_t num_kinds) {
  const std::vector<Run> runs = findRuns(
      selection, [](std::size_t, std::size_t, std::size_t kind) -> std::uint64_t { return kind; });
  return gather(
      runs,
      [&](std::size_t r) {
        return std::pair{static_cast<std::size_t>(runs[r].key),
                         static_cast<std::size_t>(runs[r].key)};
      },
      num_kinds + 1);
}

std::vector<PixelGroup> connectedGroups(const PixelSelection& selection, double cell_m) {
  const PixelPoints points(selection.view);
  const Eigen::Vector3i origin = floored(selection.view.T_world_sensor.translation() / cell_m);
  const double per_cell = 1 / cell_m;
  const std::size_t width = static_cast<std::size_t>(selection.values.width());
  const std::vector<Run> runs =
      findRuns(selection, [&](std::size_t u, std::size_t v, std::size_t kind) {
        assert(kind <= kMaxConnectedKinds);
        const Eigen::Vector3d point = points.at(v * width + u, u, v);
        return cellKey(kind, floored(point * per_cell) - origin);
      });

  KeyTable cells(runs.size());
  std::vector<std::uint32_t> cell_of_run(runs.size());
  for (std::size_t r = 0; r < runs.size(); ++r) cell_of_run[r] = cells.add(runs[r].key);

  static const std::array<std::uint64_t, 13> kOffsets = laterNeighbors();
  std::vector<std::uint32_t> parents(cells.keys().size());
  std::iota(parents.begin(), parents.end(), 0u);
  for (std::uint32_t cell = 0; cell < parents.size(); ++cell) {
    for (const std::uint64_t offset : kOffsets) {
      const std::uint32_t* neighbor = cells.find(cells.keys()[cell] + offset);
      if (neighbor) parents[rootOf(parents, cell)] = rootOf(parents, *neighbor);
    }
  }
  return gather(
      runs,
      [&](std::size_t r) {
        return std::pair{static_cast<std::size_t>(rootOf(parents, cell_of_run[r])),
                         static_cast<std::size_t>(runs[r].key >> (3 * kAxisBits))};
      },
      parents.size());
}

}  // namespace hydrabench

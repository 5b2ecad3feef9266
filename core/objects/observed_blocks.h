// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "core/geometry/box.h"
#include "core/mapping/sensor_view.h"
#include "core/mapping/voxel_grid.h"
#include "core/objects/object_candidate.h"

namespace hydrabench {

/// Finds the blocks of a volume around one object that can hold its surface, so that the rest need
/// not be integrated.
///
/// What is kept of the volume is surface that was measured, within the truncation, by a pixel of
/// the object. Such a voxel projects to within a pixel of a pixel of the object, and its range is
/// within the truncation of a range interpolated there. Blocks where no frame can have such a voxel
/// hold no face; a face next to them reaches one voxel into them. So the blocks found, and their
/// neighbours, give the same mesh as the whole volume, bit by bit.
class ObservedBlocks {
 public:
  /// @param volume                  blocks that touch it take part [m]
  /// @param max_range_difference_m  an interpolated range is no farther than this from those it is
  ///                                made of
  ObservedBlocks(const VoxelGrid& grid, const Aabb& volume, double truncation_m,
                 double max_range_difference_m);

  /// Adds the blocks where a frame may have measured the object.
  /// @param id      of the object in `ids`
  /// @param region  around its pixels
  void add(const SensorView& view, const Image<std::uint16_t>& ids, std::uint16_t id,
           const ImageRegion& region);
  /// The blocks found, in order of IndexLess.
  std::vector<BlockIndex> blocks() const;
  /// Whether a block is part of the volume.
  bool inVolume(const BlockIndex& block) const;

 private:
  std::size_t numberOf(const BlockIndex& block) const;

  VoxelGrid grid_;
  double truncation_m_;
  float max_difference_m_;
  BlockIndex low_;   ///< of the volume
  BlockIndex size_;  ///< [blocks]
  std::vector<char> observed_;
};

}  // namespace hydrabench

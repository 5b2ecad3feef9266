// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <vector>

#include "core/shape/crisp/object_points.h"
#include "core/shape/crisp/point_input.h"
#include "core/shape/latent_flow/latent_grid.h"

namespace hydrabench {

/// What one view measured in the cube around an object (latent_grid.h), cell by cell: the
/// condition of the flow of shapes. Each cell knows how many points of the object are in it, where
/// the middle of them lies, whether a ray of the camera passed through it unhindered, and whether
/// something else was measured there.
struct ViewGrid {
  static constexpr int kCellFeatures = 6;  ///< log count, middle (3, in cells), free, other
  static constexpr int kCellsOfBlock = kCellsPerBlock * kCellsPerBlock * kCellsPerBlock;
  static constexpr int kBlockFeatures = kCellsOfBlock * kCellFeatures;
  static constexpr int kGlobals = 12;

  std::vector<float> cells;  ///< kShapeTokens x kCellsOfBlock x kCellFeatures, sorted by blocks
  /// Log scale of the frame [m], direction of the camera (3), its log distance [frame], height of
  /// the camera, of the lowest point measured anywhere and of the middle of the object's points
  /// [frame], the four borders that cut the mask.
  std::array<float, kGlobals> globals = {};
};

/// @param frame  of the object, in the level frame of the points
ViewGrid makeViewGrid(const ObjectPoints& points, const LocalFrame& frame);

}  // namespace hydrabench

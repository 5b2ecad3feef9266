// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include <Eigen/Core>

namespace hydrabench {

// The cube that holds the shape of an object, in the object's frame: upright, origin at the centre
// of its box, the largest half extent is 1. The cube reaches a little farther, because a pose is
// never exact.
//
// It is divided in three ways. Nodes (32 a side) are where a distance field is sampled for the
// encoder. Blocks (4 a side) are the latent voxels: one token of the flow each, 8 nodes a side.
// Cells (16 a side, 4 per block) are where measurements are gathered and where the decoder keeps
// its features. All of them are numbered with x fastest, and lie at the centres of their part of
// the cube.
inline constexpr double kGridHalfSide = 1.2;
inline constexpr int kGridSide = 32;
inline constexpr int kBlockSide = 4;
inline constexpr int kCellSide = 16;
inline constexpr int kShapeTokens = kBlockSide * kBlockSide * kBlockSide;
inline constexpr int kNodesPerBlock = kGridSide / kBlockSide;  ///< along a side
inline constexpr int kCellsPerBlock = kCellSide / kBlockSide;  ///< along a side
inline constexpr double kGridCell = 2 * kGridHalfSide / kGridSide;
/// Distances are cut off here, in units of the frame.
inline constexpr double kTruncation = 0.25;

constexpr std::size_t gridIndex(int x, int y, int z) {
  return static_cast<std::size_t>((z * kGridSide + y) * kGridSide + x);
}
inline Eigen::Vector3d gridNode(int x, int y, int z) {
  return (Eigen::Vector3d(x, y, z).array() + 0.5) * kGridCell - kGridHalfSide;
}

/// A distance in one byte: steps of a 127th of the truncation.
inline std::int8_t quantizedDistance(double distance) {
  const double share = std::clamp(distance / kTruncation, -1.0, 1.0);
  return static_cast<std::int8_t>(std::lround(127 * share));
}

}  // namespace hydrabench

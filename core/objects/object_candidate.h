// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "core/geometry/box.h"
#include "core/mapping/voxel_grid.h"
#include "core/types/ids.h"
#include "core/types/image.h"

namespace hydrabench {

/// Pixels from (u_begin, v_begin) up to, and without, (u_end, v_end).
struct ImageRegion {
  int u_begin = 0;
  int v_begin = 0;
  int u_end = 0;
  int v_end = 0;
};

/// Something in one frame that may be an object.
struct ObjectCandidate {
  std::uint16_t id = 0;  ///< its number in the id image of the frame, from 1
  Label label = kUnknownLabel;
  bool dynamic = false;               ///< found by motion, not by its class
  InstanceId instance = kNoInstance;  ///< in the frame it is from; kNoInstance for other sources
  std::vector<std::uint32_t> pixels;  ///< row-major indices, ascending; all of them measured
  ImageRegion region;                 ///< around its pixels
  std::vector<GlobalVoxel> voxels;    ///< of the tracker's grid, sorted by IndexLess, unique
  Aabb box;                           ///< of its points in the world [m]
  Eigen::Vector3d centroid = Eigen::Vector3d::Zero();  ///< mean of its points in the world [m]
};

/// The candidates of a frame.
struct FrameCandidates {
  Image<std::uint16_t> ids;  ///< 0: background
  std::vector<ObjectCandidate> candidates;
};

}  // namespace hydrabench

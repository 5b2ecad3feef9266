// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include <Eigen/Core>

#include "core/mapping/tsdf_volume.h"
#include "core/types/color.h"
#include "core/types/ids.h"

namespace hydrabench {

/// Triangles of one block: three vertices each, not shared.
struct TriangleSoup {
  std::vector<Eigen::Vector3d> vertices;  ///< world [m]; 3 per triangle, counter-clockwise from
                                          ///< outside (the side of positive distance)
  std::vector<Rgb> colors;                ///< per vertex
  std::vector<Label> labels;              ///< per vertex; kUnknownLabel where none is known
};

/// Marching cubes (Lorensen and Cline, SIGGRAPH 1987) over the cubes whose lowest corner is a voxel
/// of this block; they reach into the neighbours at +x, +y, +z (faces, edges and the corner) and
/// are left out where one is missing. A cube needs eight corners of at least min_weight (and above
/// 0). A vertex takes the label of the nearer corner, at equal distance of the heavier one; colours
/// are linear between coloured voxels. Two blocks compute the same bits on their common edges, so
/// merging vertices leaves no crack. Blocks have at most 63 voxels along an edge.
TriangleSoup marchingCubes(const TsdfVolume& volume, const BlockIndex& block, double min_weight);

}  // namespace hydrabench

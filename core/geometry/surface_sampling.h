// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "core/geometry/mesh.h"

namespace hydrabench {

struct SurfaceSamples {
  std::vector<Eigen::Vector3d> points;  ///< N x 3 [m]
  std::vector<std::uint32_t> faces;     ///< face of each point
};

/// `count` points drawn uniformly by area, independent of how the surface is cut into triangles.
/// Same seed, same points on every platform. Empty for a mesh without area.
SurfaceSamples sampleSurface(const Mesh& mesh, std::size_t count, std::uint64_t seed);

}  // namespace hydrabench

// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include <Eigen/Core>

#include "core/geometry/mesh.h"

namespace hydrabench {

/// Shading normals, three per face: the mean over the faces around the vertex, weighted by their
/// area, of those that meet this face at less than the crease angle. So round surfaces look round,
/// edges stay sharp, and large flat faces look flat up to their border.
std::vector<Eigen::Vector3f> cornerNormals(const Mesh& mesh, double crease_rad = 0.6);

}  // namespace hydrabench

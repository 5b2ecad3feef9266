// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "eval/simulation/shape_family.h"

namespace hydrabench {

/// The zero set of the union of the parts on a regular grid: one vertex on every grid edge that
/// crosses it, within a thousandth of the pitch of the zero set. Marching cubes (Lorensen and
/// Cline, SIGGRAPH 1987) with tables built so that the result is always a closed, oriented
/// 2-manifold: on an ambiguous cube face the inside corners are kept apart, seen from either side,
/// and no triangle edge other than a contour segment lies within a cube face. Only cells that the
/// Lipschitz bound cannot rule out are visited, each with only the members of the union that can
/// matter there.
SurfaceMesh extractSurface(const std::vector<ShapePart>& parts, double pitch_m);

}  // namespace hydrabench

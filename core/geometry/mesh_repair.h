// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/geometry/box.h"
#include "core/geometry/mesh.h"

namespace hydrabench {

/// CGAL's polygon-mesh processing. Slow to compile, so all of it stands in mesh_repair.cpp.

/// Closes every boundary loop with a refined, faired patch. Colours are lost here and in a wrap.
/// Triangle soups are oriented and made manifold first.
Mesh withHolesFilled(const Mesh& mesh);

/// Watertight, orientable 2-manifold that encloses the input at a distance of at most about
/// `offset` (Alliez et al., "Alpha wrapping with an offset", ACM TOG 2022).
/// @param alpha   size of the smallest hole that stays open to the carving sphere [m]
/// @param offset  distance of the wrap to the input [m]
Mesh alphaWrapped(const Mesh& mesh, double alpha, double offset);

/// Box of (almost) smallest volume around the vertices, from the convex hull. Throws InputError for
/// fewer than 4 vertices that span a volume: use the AABB then.
OrientedBox smallestBox(const Mesh& mesh);

/// Exact boolean intersection volume of two closed meshes [m^3], by corefinement. Throws InputError
/// unless both are watertight and do not intersect themselves.
double intersectionVolume(const Mesh& a, const Mesh& b);

}  // namespace hydrabench

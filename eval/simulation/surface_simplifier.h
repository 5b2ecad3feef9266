// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include "eval/simulation/shape_family.h"

namespace hydrabench {

/// Collapses edges of a closed manifold mesh onto one of their ends, cheapest first, by quadric
/// error (Garland and Heckbert, SIGGRAPH 1997). Vertices keep their positions, so they stay on the
/// zero set; the mesh stays closed and manifold; no face turns over; borders between parts count as
/// creases and keep their course.
/// @param max_error_m   root mean square distance to the planes a vertex stands for, up to which
/// edges are collapsed
/// @param max_faces     collapses go on beyond max_error_m (up to twenty times that) while there
/// are more faces than this
SurfaceMesh simplifySurface(const SurfaceMesh& surface, double max_error_m, std::size_t max_faces);

}  // namespace hydrabench

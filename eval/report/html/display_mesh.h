// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include "core/geometry/mesh.h"

namespace hydrabench {

/// A mesh to look at: at most about `faces` faces by edge collapse (meshoptimizer: several times
/// faster than decimated() of core/geometry, and nothing is measured on what it makes), then edges
/// longer than a tenth of the box's diagonal halved, so that a value per vertex (an error) can vary
/// over large flat faces. Colours are kept.
Mesh displayMesh(const Mesh& mesh, std::size_t faces);

/// The same without the halving, for a mesh that shows its own colours.
Mesh coarseMesh(const Mesh& mesh, std::size_t faces);

}  // namespace hydrabench

// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include "core/geometry/mesh.h"

namespace hydrabench {

/// What can be said of a mesh by its connectivity alone.
struct MeshTopology {
  std::size_t boundary_edges = 0;     ///< edges of exactly one face
  std::size_t nonmanifold_edges = 0;  ///< edges of three or more faces
  std::size_t misoriented_edges = 0;  ///< edges whose two faces run the same way
  std::size_t components = 0;         ///< face sets connected over edges
  double boundary_length = 0;         ///< [m]

  /// Closed and consistently oriented: inside and outside are defined.
  bool watertight() const {
    return boundary_edges == 0 && nonmanifold_edges == 0 && misoriented_edges == 0 &&
           components > 0;
  }
};

/// Vertices at exactly equal positions count as one; degenerate faces (two corners in
/// one) are ignored.
MeshTopology analyzeTopology(const Mesh& mesh);

/// Merges vertices at exactly equal positions and drops degenerate faces (two corners in one) and
/// unused vertices.
Mesh welded(const Mesh& mesh);

/// Quadric edge collapse (OpenMesh) of the welded mesh until `target_faces` or until no collapse
/// keeps the root mean square distance to the planes of the merged faces below max_error [m] and
/// turns no face by more than 60 degrees. Watertight meshes stay watertight. The vertices are some
/// of the input's, at their places and with their colours.
Mesh decimated(const Mesh& mesh, std::size_t target_faces, double max_error);

/// Faces connected over shared vertices (those at equal positions count as one), largest component
/// (by area) first.
std::vector<Mesh> connectedComponents(const Mesh& mesh);

}  // namespace hydrabench

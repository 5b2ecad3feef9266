// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>

#include <Eigen/Core>

#include "core/geometry/mesh.h"

namespace hydrabench {

/// A mesh as bytes for web/mesh_decoder.js. Vertices stand in the order in which the faces first
/// use them; those that no face uses are dropped.
struct PackedMesh {
  std::size_t vertices = 0;
  std::size_t faces = 0;
  Eigen::Vector3d low = Eigen::Vector3d::Zero();   ///< of the mesh's box [m]
  Eigen::Vector3d size = Eigen::Vector3d::Zero();  ///< its edges [m]
  bool has_colors = false;
  bool wide = false;  ///< indices have 4 bytes instead of 2
  /// All little endian, numbers of several bytes cut into planes (all lowest bytes first), since
  /// neighbours are alike: then it compresses well.
  /// - x of all vertices, then y, then z: uint16, 0 .. 65535 over the box, each less the one before
  /// - with colours: red of all vertices, green, blue: uint8, each less the one before
  /// - 3 per face: h - index, where h is the number of vertices met so far
  std::string bytes;
};
PackedMesh packMesh(const Mesh& mesh);
/// Its vertices where the browser will draw them: for values per vertex, in the order of the bytes.
Mesh unpackMesh(const PackedMesh& packed);

}  // namespace hydrabench

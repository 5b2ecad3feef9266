// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <unordered_map>
#include <vector>

#include "core/geometry/mesh.h"
#include "eval/report/html/packed_mesh.h"

namespace hydrabench {

/// The shapes of a world, equal ones once: rows that differ in one decision share most of them.
/// What is added must outlive the set.
class ShapeSet {
 public:
  std::size_t add(const Mesh& mesh);  ///< its number; that of an equal one if there is one
  const Mesh& mesh(std::size_t shape) const { return *meshes_[shape]; }
  std::size_t size() const { return meshes_.size(); }

 private:
  std::vector<const Mesh*> meshes_;
  std::unordered_multimap<std::size_t, std::size_t> by_hash_;
};

/// A pair of shapes whose distance is shown.
struct ShapePair {
  std::size_t estimate = 0;  ///< numbers in the set
  std::size_t truth = 0;
  friend auto operator<=>(const ShapePair&, const ShapePair&) = default;
};

/// Distances [mm], 255: that or more; one byte per vertex of the packed mesh.
struct PairDistances {
  std::string on_estimate;  ///< of the estimate's vertices to the true surface
  std::string on_truth;     ///< of the true surface's vertices to the estimate
};

/// Every shape of the set, coarsened to about `faces` faces.
std::vector<PackedMesh> packShapes(const ShapeSet& shapes, std::size_t faces);

/// Distances are to the shapes as they are, from the vertices that are drawn.
std::vector<PairDistances> pairDistances(const ShapeSet& shapes,
                                         const std::vector<PackedMesh>& packed,
                                         const std::vector<ShapePair>& pairs);

}  // namespace hydrabench

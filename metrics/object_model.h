// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "core/geometry/box.h"
#include "core/geometry/mesh.h"
#include "core/geometry/mesh_topology.h"
#include "metrics/voxel_set.h"

namespace hydrabench {

/// An object's world mesh, prepared once so that scoring it against many others is cheap.
/// Immutable; may be shared by threads.
///
/// Samples are seeded by the role and the connectivity of the mesh, not by id: no score changes
/// with ids, order or a rigid motion, while a mesh compared with itself is still drawn twice,
/// independently.
class ObjectModel {
 public:
  enum class Role { kEstimate, kTruth };
  struct Config {
    std::size_t samples = 10000;       ///< N, drawn uniformly by area
    VoxelLattice grid;                 ///< common to all objects
    std::size_t jittered_origins = 8;  ///< further grids, for the spread of v_iou
    std::uint64_t seed = 0;
  };

  ObjectModel(Mesh mesh_world, Role role, const Config& config);
  ~ObjectModel();
  ObjectModel(ObjectModel&&) noexcept;
  ObjectModel& operator=(ObjectModel&&) noexcept;

  const Mesh& mesh() const;
  const Aabb& box() const;                 ///< objectBox() of the mesh
  double halfDiagonal() const;             ///< d_diag of box() [m]; 0 without vertices
  const OrientedBox& orientedBox() const;  ///< objectOrientedBox() of the mesh
  const MeshTopology& topology() const;
  bool watertight() const { return topology().watertight(); }
  bool hasSurface() const { return !samples().empty(); }  ///< false: no face, or none with area

  std::span<const Eigen::Vector3d> samples() const;
  /// To the nearest sample [m^2]. Needs hasSurface().
  double squaredDistanceToSamples(const Eigen::Vector3d& point) const;
  /// Distance to the nearest point on any triangle [m]; below 1e-9 m it is exactly 0: a sample of a
  /// face is off its plane by rounding alone, and a surface compared with itself has distance 0.
  /// Needs hasSurface().
  double distanceToSurface(const Eigen::Vector3d& point) const;

  /// chamfer_sq of this surface against itself, drawn a second time [m^2]: what a perfect estimate
  /// would score. Computed on first use. Without a surface: undefined.
  std::optional<double> samplingFloor() const;

  /// On Config::grid first, then on the jittered ones. nullopt: too large (see voxelize.h).
  std::span<const std::optional<VoxelSet>> solidVoxels() const;
  std::span<const std::optional<VoxelSet>> surfaceVoxels() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace hydrabench

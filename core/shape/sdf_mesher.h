// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <optional>
#include <span>

#include <Eigen/Core>

#include "core/geometry/mesh.h"

namespace hydrabench {

/// A distance field asked at many points at once: writes one value per point, negative inside. May
/// be called from several threads at once.
using SdfField = std::function<void(std::span<const Eigen::Vector3f>, std::span<float>)>;

struct SdfMesherConfig {
  double half_side = 1.1;  ///< of the cube around the origin that is searched
  int resolution = 64;     ///< cells along a side: a power of two, at least coarse_resolution
  int coarse_resolution = 16;  ///< where the search begins; a power of two
  /// A cell is refined where |value| at its centre is below this many of its half diagonals: more
  /// than 1 for a field that is no exact distance.
  double refine_margin = 1.5;
};

/// Mesh of the largest piece of the zero set, by marching cubes on a grid that is refined only near
/// the surface. Closed, unless the zero set leaves the cube; oriented outwards. nullopt where there
/// is no zero crossing, or where a value that matters is not finite. The same for any number of
/// threads.
std::optional<Mesh> meshZeroSet(const SdfField& field, const SdfMesherConfig& config);

}  // namespace hydrabench

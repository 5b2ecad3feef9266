// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <optional>
#include <span>

#include <Eigen/Core>

#include "core/config/config_reader.h"
#include "core/geometry/mesh.h"

namespace hydrabench {

/// A distance field asked at many points at once: writes one value per point, negative inside. May
/// be called from several threads at once.
using SdfField = std::function<void(std::span<const Eigen::Vector3f>, std::span<float>)>;

struct SdfMesherConfig {
  double half_side = 1.1;      ///< of the cube around the origin that is searched
  int resolution = 64;         ///< cells along a side: a power of two, at least coarse_resolution
  int coarse_resolution = 16;  ///< where the search begins; a power of two
  /// A cell is refined where the zero set passes between its corners, and it is looked into where
  /// |value| at a corner is below this many of its half diagonals. 0.6 sees every sheet and 1 every
  /// speck of an exact distance; a field that is clamped at a distance c needs less than c over
  /// the half diagonal of a coarse cell.
  double refine_margin = 0.7;
};
/// Keys resolution, coarse_resolution and refine_margin; the cube belongs to the field.
void read(ConfigReader& reader, SdfMesherConfig& config);

/// Mesh of the largest piece (by area) of the zero set, by marching cubes on a grid that is refined
/// only near the surface; on the finest level the surface is followed to where the coarser ones saw
/// none, so thin parts are not cut off. Every grid point is evaluated at most once, in batches
/// whose bounds do not depend on the number of threads: the result is the same for any number.
/// Closed, unless the zero set leaves the cube; oriented outwards. nullopt where no zero crossing
/// is found, or where a value is not finite.
std::optional<Mesh> meshZeroSet(const SdfField& field, const SdfMesherConfig& config);

}  // namespace hydrabench

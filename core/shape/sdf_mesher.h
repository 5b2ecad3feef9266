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
  /// Value of the field at the surface. A learned distance errs on the far side where it is unsure:
  /// thin parts that 0 loses are there a little above it.
  double level = 0;
  /// Pieces with at least this share of the largest one's area are kept. 1: the largest alone, as
  /// CRISP does.
  double min_piece_share = 1;
};
/// All keys but the cube, which belongs to the field.
void read(ConfigReader& reader, SdfMesherConfig& config);

/// Mesh of the largest piece (by area) of a level set, and of others as the config says, by
/// marching cubes on a grid that is refined only near the surface; on the finest level the surface
/// is followed to where the coarser ones saw none, so thin parts are not cut off. Every grid point
/// is evaluated at most once, in batches whose bounds do not depend on the number of threads: the
/// result is the same for any number. Closed, unless the level set leaves the cube; oriented
/// outwards. nullopt where the field does not cross the level, or where a value is not finite.
std::optional<Mesh> meshLevelSet(const SdfField& field, const SdfMesherConfig& config);

}  // namespace hydrabench

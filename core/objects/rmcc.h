// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "core/config/config_reader.h"
#include "core/geometry/mesh.h"
#include "core/shape/shape_estimator.h"
#include "core/types/image.h"

namespace hydrabench {

/// Reprojection-mask consistency check of the paper: an estimated shape, projected into the view it
/// was estimated from, must fall on the pixels of the object.
struct RmccConfig {
  /// none: every estimate is accepted. published: overlap O > min_overlap. extended: coverage and
  /// depth as well, which O cannot see: a tiny mesh anywhere inside the mask has O = 1, and so has
  /// a shape with the right silhouette at the wrong depth. Beyond the paper.
  std::string check = "published";
  double min_overlap = 0.21;  ///< tau_O of the paper; strictly above
  /// How the projected mask of O is made. points: the pixels on which points fall that are drawn
  /// on the surface (paper). raster: the pixels whose centres the surface covers.
  std::string mask = "points";
  int points = 20000;  ///< not published
  // Of the extended check; all strictly.
  double min_coverage = 0.5;
  /// The depth residual must be below the larger of the two.
  double max_depth_residual_m = 0.05;
  double max_depth_residual_share = 0.05;  ///< of the diagonal of the estimate's world box
  friend bool operator==(const RmccConfig&, const RmccConfig&) = default;
};
void read(ConfigReader& reader, RmccConfig& config);

struct RmccScores {
  /// O = |projected and observed| / |projected|, over sets of pixels of the image; 0 where nothing
  /// is projected into it.
  double overlap = 0;
  /// |projected and observed| / |observed|, the projected mask rasterised whatever config.mask is:
  /// points leave gaps in large masks. 0 where nothing is observed.
  double coverage = 0;
  /// Median of |rendered - measured| z-depth over the pixels that are projected, observed and
  /// measured [m]; nullopt where there are none.
  std::optional<double> depth_residual_m = std::nullopt;
};

/// @param mesh_camera  the estimate, scaled and placed, in the camera frame of the view [m]
RmccScores rmccScores(const Mesh& mesh_camera, const ShapeObservation& view,
                      const RmccConfig& config);

/// Why the check turns an estimate down: "overlap", "coverage" or "depth_residual", the first that
/// fails; nullptr where it passes. A function of the scores, so that thresholds can be swept
/// afterwards.
/// @param diagonal_m  of the estimate's axis-aligned box in the world
const char* rmccRejection(const RmccScores& scores, double diagonal_m, const RmccConfig& config);

/// The projected mask of O: 1 where the mesh is, 0 elsewhere. Points behind the camera and outside
/// the image do not count.
Image<std::uint8_t> projectedMask(const Mesh& mesh_camera, const Camera& camera,
                                  const RmccConfig& config);

}  // namespace hydrabench

// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>
#include <string>

#include <Eigen/Core>

#include "baselines/template_cad/footprint.h"
#include "core/config/config_reader.h"
#include "core/geometry/mesh.h"
#include "core/geometry/raycaster.h"
#include "core/geometry/transform.h"

namespace hydrabench {

/// How a template is put where a landmark is. SlideSLAM's front-end has a centre (mid_extent) and a
/// yaw (PCA of the corners of the hull); its back-end draws templates with a constant scale and a
/// yaw that has no relation to the object. The height it leaves open.
struct PlacementConfig {
  /// centroid: the moving average of the measured centres. mid_extent: the middle of the extents of
  /// the accumulated points, along their main axes.
  std::string position = "mid_extent";
  /// fixed: the template's axes are the world's. hull_pca: its longer side along the main axis of
  /// the points' footprint (of the hull's area), which leaves open which end is the front.
  /// chamfer_search: of all yaws in steps of yaw_step_deg the one with the least mean distance from
  /// the points to the template.
  std::string yaw = "hull_pca";
  double yaw_step_deg = 10;
  /// fixed: the size of the mesh. fitted_to_extents: stretched to the extents of the points along
  /// the template's axes; stronger than SlideSLAM.
  std::string scale = "fixed";
  /// ground: the template stands at ground_z_m. lowest: at the 5th percentile of the heights of the
  /// points, for ground that is not level. centroid: its middle is at their mean height.
  std::string z = "ground";
  double ground_z_m = 0;
};

/// The canonical shape of a class.
class TemplateModel {
 public:
  /// @param mesh  object frame [m]: z up, x to the front. Moved so that it stands on z = 0 with the
  ///              middle of its footprint's box at the origin. Not empty.
  explicit TemplateModel(Mesh mesh);

  struct Placed {
    Transform T_world_object = Transform::Identity();
    Mesh mesh;  ///< world frame [m]
  };
  /// @param center     moving average of the landmark's measurements [m]
  /// @param footprint  of `points`
  /// @param points     world [m]; not empty
  Placed place(const PlacementConfig& config, const Eigen::Vector2d& center,
               const Footprint& footprint, std::span<const Eigen::Vector3d> points) const;

 private:
  double yawByChamfer(const Eigen::Vector3d& position, double step_deg,
                      std::span<const Eigen::Vector3d> points) const;

  Mesh mesh_;
  double height_ = 0;     ///< [m]
  double major_yaw_ = 0;  ///< of the longer side in the object frame [rad]
  Raycaster surface_;
};

void read(ConfigReader& reader, PlacementConfig& config);

}  // namespace hydrabench

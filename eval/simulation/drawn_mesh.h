// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "core/geometry/raycaster.h"
#include "core/geometry/transform.h"
#include "eval/simulation/scene.h"

namespace hydrabench {

/// What a renderer must know about a mesh beyond its triangles: normals, materials, label. In
/// floats, to be read once per pixel.
class DrawnMesh {
 public:
  struct SurfaceSample {
    Eigen::Vector3f
        normal;  ///< interpolated where the surface is smooth; world frame, towards the viewer
    Eigen::Vector3f face_normal;  ///< of the flat triangle; world frame, towards the viewer
    Eigen::Vector3f reflectance;  ///< linear light, [0, 1]
    float gloss = 0;
  };
  DrawnMesh(const Surface& surface, const Transform& T_world_mesh, Label label, bool emissive);

  /// @param hit  on this mesh at `point` (world frame), by a ray of the given direction
  SurfaceSample sample(const Raycaster::Hit& hit, const Eigen::Vector3f& point,
                       const Eigen::Vector3f& direction) const;
  /// Outward, world frame.
  const Eigen::Vector3f& faceNormal(std::uint32_t face) const { return face_normals_[face]; }
  Label label() const { return label_; }
  bool emissive() const { return emissive_; }

 private:
  std::vector<Eigen::Vector3f> corner_normals_;  ///< three per face, world frame
  std::vector<Eigen::Vector3f> face_normals_;    ///< world frame
  std::vector<Rgb> corner_colors_;  ///< three per face; only for surfaces without materials
  std::vector<Material> materials_;
  std::vector<std::uint16_t> face_material_;
  Eigen::Matrix3f R_mesh_world_;
  Eigen::Vector3f t_mesh_world_;
  Label label_;
  bool emissive_;
};

}  // namespace hydrabench

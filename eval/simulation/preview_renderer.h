// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include <Eigen/Core>

#include "core/geometry/camera.h"
#include "core/geometry/mesh.h"
#include "core/geometry/transform.h"
#include "core/types/color.h"
#include "core/types/image.h"
#include "eval/simulation/shape_family.h"

namespace hydrabench {

/// A mesh in a picture. Its looks, in this order: materials per face; else the mesh's vertex
/// colours; else one colour.
struct PreviewObject {
  Mesh mesh;
  Transform T_world_mesh = Transform::Identity();
  std::vector<Material> materials;
  std::vector<std::uint16_t> face_material;  ///< index into materials, per face
  Rgb color{200, 200, 200};
};
PreviewObject previewObject(const ShapeInstance& instance, const SurfaceMesh& surface,
                            const Transform& T_world_object);

struct PreviewStyle {
  bool floor = true;  ///< endless plane in the background's colour that takes shadows
  double floor_z_m = 0;
  Rgb background{236, 238, 240};
  Eigen::Vector3d to_light{0.35, 0.55, 1.0};  ///< direction of the sun, world frame
  double light_radius = 0.12;    ///< softness of shadows: radius of the sun at distance 1
  double ambient_range_m = 1.5;  ///< things farther away than this darken nothing
  int supersampling = 2;         ///< squared samples per pixel
  int rays_per_sample = 6;       ///< of shadow and of ambient light, each
};

/// A picture for people: sun with soft shadows, ambient occlusion, antialiasing. Same input, same
/// bytes, any number of threads.
Image<Rgb> renderPreview(const std::vector<PreviewObject>& objects, const Camera& camera,
                         const Transform& T_world_camera, const PreviewStyle& style = {});

/// Camera of the given vertical opening angle.
Camera previewCamera(int width, int height, double vertical_fov_rad);
/// Pose from which a box fills the picture, seen from the given side (azimuth from the x axis) and
/// height angle.
Transform previewPose(const Aabb& box, const Camera& camera, double azimuth_rad,
                      double elevation_rad, double margin = 1.05);

}  // namespace hydrabench

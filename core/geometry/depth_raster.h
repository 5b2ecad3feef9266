// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/geometry/camera.h"
#include "core/geometry/mesh.h"
#include "core/types/image.h"

namespace hydrabench {

/// Depth image of a mesh: per pixel the smallest z-depth [m] at which the ray through its centre
/// meets a triangle from either side; 0 where it meets none. In double, edges included, faces that
/// reach behind the camera handled without clipping (Olano and Greer, "Triangle Scan Conversion
/// using 2D Homogeneous Coordinates", Graphics Hardware 1997).
/// @param mesh_camera  in the camera frame [m], finite
Image<float> rasterizeDepth(const Mesh& mesh_camera, const Camera& camera);

}  // namespace hydrabench

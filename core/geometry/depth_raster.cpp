// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "core/geometry/depth_raster.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Geometry>

namespace hydrabench {
namespace {

/// Pixels that a face may cover, both ends inclusive.
struct PixelBox {
  int u_low, u_high, v_low, v_high;
};

PixelBox pixelBox(const Eigen::Vector3d (&corners)[3], const Camera& camera) {
  PixelBox all{0, camera.width - 1, 0, camera.height - 1};
  double u_low = std::numeric_limits<double>::infinity();
  double v_low = u_low, u_high = -u_low, v_high = -u_low;
  for (const Eigen::Vector3d& corner : corners) {
    const auto pixel = camera.project(corner);
    if (!pixel) return all;  // reaches behind the camera: its image has no end
    u_low = std::min(u_low, pixel->x());
    u_high = std::max(u_high, pixel->x());
    v_low = std::min(v_low, pixel->y());
    v_high = std::max(v_high, pixel->y());
  }
  // Compared as doubles first: near the camera's plane the numbers do not fit into an int. A pixel
  // of margin takes up the rounding of the projection.
  const auto low = [](double value, int size) {
    return static_cast<int>(std::clamp(std::floor(value) - 1, 0.0, double(size)));
  };
  const auto high = [](double value, int size) {
    return static_cast<int>(std::clamp(std::ceil(value) + 1, -1.0, double(size - 1)));
  };
  return {low(u_low, camera.width), high(u_high, camera.width), low(v_low, camera.height),
          high(v_high, camera.height)};
}

}  // namespace

Image<float> rasterizeDepth(const Mesh& mesh_camera, const Camera& camera) {
  Image<float> depth(camera.width, camera.height);
  for (const Eigen::Vector3i& face : mesh_camera.faces) {
    const auto corner = [&](int i) { return mesh_camera.vertices[static_cast<std::size_t>(i)]; };
    const Eigen::Vector3d corners[3] = {corner(face.x()), corner(face.y()), corner(face.z())};
    if (!(std::max({corners[0].z(), corners[1].z(), corners[2].z()}) > 0)) continue;
    // A ray d meets the face where d lies on the same side of the three planes through the origin
    // and an edge; it does so at z = volume / (sum of the three).
    const Eigen::Vector3d edges[3] = {corners[1].cross(corners[2]), corners[2].cross(corners[0]),
                                      corners[0].cross(corners[1])};
    const double volume = corners[0].dot(edges[0]);
    if (volume == 0) continue;  // seen edge-on, or without area
    const double sign = volume > 0 ? 1 : -1;
    const PixelBox box = pixelBox(corners, camera);
    for (int v = box.v_low; v <= box.v_high; ++v) {
      const double y = (v - camera.cy) / camera.fy;
      double row[3], step[3];
      for (int k = 0; k < 3; ++k) {
        row[k] = sign * (edges[k].y() * y + edges[k].z() - edges[k].x() * camera.cx / camera.fx);
        step[k] = sign * edges[k].x() / camera.fx;
      }
      for (int u = box.u_low; u <= box.u_high; ++u) {
        const double a = row[0] + u * step[0];
        const double b = row[1] + u * step[1];
        const double c = row[2] + u * step[2];
        if (!(a >= 0 && b >= 0 && c >= 0)) continue;
        const auto z = static_cast<float>(sign * volume / (a + b + c));
        float& nearest = depth(u, v);
        if (z < std::numeric_limits<float>::infinity() && (nearest == 0 || z < nearest)) {
          nearest = z;
        }
      }
    }
  }
  return depth;
}

}  // namespace hydrabench

// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <span>

#include <Eigen/Core>

#include "core/geometry/mesh.h"

namespace hydrabench {

/// Rays against triangles, and nearest points on them. Embree 3 or 4 underneath, in raycaster.cpp
/// only. Queries are thread-safe.
class Raycaster {
 public:
  static constexpr std::uint32_t kMiss = std::numeric_limits<std::uint32_t>::max();

  struct Ray {
    Eigen::Vector3f origin;
    Eigen::Vector3f direction;  ///< need not be a unit vector; distances are in multiples of it
    float min_distance = 0;
    float max_distance = std::numeric_limits<float>::infinity();
  };
  struct Hit {
    std::uint32_t mesh = kMiss;  ///< index returned by add(); kMiss: nothing hit
    std::uint32_t face = kMiss;
    float distance = std::numeric_limits<float>::infinity();
    float u = 0;  ///< barycentric weight of the face's second vertex
    float v = 0;  ///< and of its third
    explicit operator bool() const { return mesh != kMiss; }
  };
  struct SurfacePoint {
    std::uint32_t mesh = kMiss;
    std::uint32_t face = kMiss;
    Eigen::Vector3d position = Eigen::Vector3d::Zero();
    double distance = std::numeric_limits<double>::infinity();  ///< [m], computed in double
  };

  Raycaster();
  ~Raycaster();
  Raycaster(Raycaster&&) noexcept;
  Raycaster& operator=(Raycaster&&) noexcept;

  /// Adds the triangles of a mesh; returns its index (0, 1, 2 ...). Degenerate faces are kept but
  /// never hit.
  std::uint32_t add(const Mesh& mesh);
  /// Builds the hierarchy; call once, after the last add() and before any query. Same bytes for any
  /// thread count.
  void commit();

  Hit intersect(const Ray& ray) const;
  /// Many rays that lie close together (pixels of a tile): several times faster than one by one.
  /// hits.size() == rays.size(). Depends on the rays of the span and their order only; the order
  /// may decide which of two faces a ray through their common edge hits.
  void intersect(std::span<const Ray> rays, std::span<Hit> hits) const;
  /// blocked[i] = 1 where anything lies between min_distance and max_distance, else 0.
  void occluded(std::span<const Ray> rays, std::span<std::uint8_t> blocked) const;

  /// Nearest point on any triangle within max_distance [m]; face == kMiss if there is none, of
  /// several the one of lowest mesh and face. The hierarchy is searched with float boxes widened by
  /// their rounding, the distance itself is computed in double.
  SurfacePoint nearest(const Eigen::Vector3d& query,
                       double max_distance = std::numeric_limits<double>::infinity()) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// Nearest point on a triangle (Ericson, Real-Time Collision Detection, 5.1.5).
Eigen::Vector3d nearestPointOnTriangle(const Eigen::Vector3d& query, const Eigen::Vector3d& a,
                                       const Eigen::Vector3d& b, const Eigen::Vector3d& c);

}  // namespace hydrabench

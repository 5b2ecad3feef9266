// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/geometry/raycaster.h"
#include "eval/simulation/drawn_mesh.h"
#include "eval/simulation/scene.h"

namespace hydrabench {

/// Rays against movers, each of which is where it is at the time of the rays. Every part has a
/// hierarchy in its own frame and the rays are carried into it, so that nothing is rebuilt as time
/// goes on; a mover that no ray comes near costs one look at its place. Queries are thread-safe.
class MoverCaster {
 public:
  /// @param movers  must stay where they are
  explicit MoverCaster(std::span<const Mover> movers);

  bool empty() const { return movers_.empty(); }

  /// Puts hits on movers in place of farther ones. Hit::mesh is then first_mesh plus the number of
  /// the part, counted through all movers.
  void intersect(std::int64_t stamp_ns, std::span<const Raycaster::Ray> rays,
                 std::uint32_t first_mesh, std::span<Raycaster::Hit> hits) const;
  /// Sets blocked[i] to 1 where a mover lies between min_distance and max_distance.
  void occluded(std::int64_t stamp_ns, std::span<const Raycaster::Ray> rays,
                std::span<std::uint8_t> blocked) const;

  /// Index of the mover that a part belongs to.
  std::size_t moverOf(std::size_t part) const { return parts_[part].mover; }
  Label labelOf(std::size_t part) const { return parts_[part].drawn.label(); }
  /// As DrawnMesh::sample(), of a part that was hit at that time.
  DrawnMesh::SurfaceSample sample(std::int64_t stamp_ns, std::size_t part,
                                  const Raycaster::Hit& hit, const Eigen::Vector3f& point,
                                  const Eigen::Vector3f& direction) const;
  /// Outward, world frame.
  Eigen::Vector3f faceNormal(std::int64_t stamp_ns, std::size_t part, std::uint32_t face) const;

 private:
  struct Part {
    std::size_t mover = 0;
    std::span<const TimedPose> poses;
    Raycaster caster;
    DrawnMesh drawn;
  };
  /// All parts stay within `radius` of the origin of the first one.
  struct Extent {
    std::size_t first_part = 0;
    std::size_t end_part = 0;
    float radius = 0;
  };
  /// Calls body(part, its pose, indices of the rays, the rays in its frame) for the parts of all
  /// movers that some of the rays may meet.
  template <typename Body>
  void forPartsNear(std::int64_t stamp_ns, std::span<const Raycaster::Ray> rays,
                    const Body& body) const;

  std::vector<Part> parts_;
  std::vector<Extent> movers_;
};

}  // namespace hydrabench

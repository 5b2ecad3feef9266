// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>

#include "core/geometry/camera.h"
#include "core/geometry/raycaster.h"
#include "core/geometry/transform.h"
#include "core/types/frame.h"
#include "eval/simulation/drawn_mesh.h"
#include "eval/simulation/scene.h"

namespace hydrabench {

/// What an ideal camera sees. All images have the size of the camera.
struct RenderedView {
  Image<Rgb> color;
  Image<float> depth;             ///< z-depth [m] at any distance; 0 where no surface is hit
  Image<Label> labels;            ///< kUnknownLabel where no surface is hit
  Image<std::int32_t> objects;    ///< index into Scene::objects, movers counted on behind them;
                                  ///< -1: structure or nothing
  Image<std::uint8_t> incidence;  ///< cosine between ray and surface normal, 255 for head-on
};

/// Ray-traces a scene: procedural materials, lambert shading under the lamps of the room, one
/// shadow ray a pixel. Movers stand where they are at the time of the picture. Tiles are rendered
/// in parallel; the pixels do not depend on the number of threads.
class RgbdRenderer {
 public:
  struct Config {
    bool with_overhead = true;  ///< false: ceilings and their lamps are not drawn (but still
                                ///< light), for overview pictures
    bool with_color = true;     ///< false: colour stays empty, which saves the shading
  };
  explicit RgbdRenderer(std::shared_ptr<const Scene> scene) : RgbdRenderer(std::move(scene), {}) {}
  RgbdRenderer(std::shared_ptr<const Scene> scene, const Config& config);
  ~RgbdRenderer();
  RgbdRenderer(RgbdRenderer&&) noexcept;
  RgbdRenderer& operator=(RgbdRenderer&&) noexcept;

  RenderedView render(const Camera& camera, const Transform& T_world_camera,
                      std::int64_t stamp_ns = 0) const;

  /// The surfaces that stand still, for other questions (visibility, clearance). Mesh i <
  /// objects.size() is object i, then come the drawn parts of the structure.
  const Raycaster& raycaster() const;

  bool hasMovers() const;
  /// Puts hits on movers at a time in place of farther ones of raycaster(). Their meshes count on
  /// behind those of it.
  void intersectMovers(std::int64_t stamp_ns, std::span<const Raycaster::Ray> rays,
                       std::span<Raycaster::Hit> hits) const;
  /// What was hit at a time looks like, and its class.
  DrawnMesh::SurfaceSample sample(std::int64_t stamp_ns, const Raycaster::Ray& ray,
                                  const Raycaster::Hit& hit) const;
  Label labelOf(const Raycaster::Hit& hit) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace hydrabench

// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <memory>

#include "core/geometry/camera.h"
#include "core/geometry/transform.h"
#include "core/types/frame.h"
#include "eval/simulation/scene.h"

namespace hydrabench {

/// What an ideal camera sees. All images have the size of the camera.
struct RenderedView {
  Image<Rgb> color;
  Image<float> depth;             ///< z-depth [m] at any distance; 0 where no surface is hit
  Image<Label> labels;            ///< kUnknownLabel where no surface is hit
  Image<std::int32_t> objects;    ///< index into Scene::objects; -1: structure or nothing
  Image<std::uint8_t> incidence;  ///< cosine between ray and surface normal, 255 for head-on
};

/// Ray-traces a scene: procedural materials, lambert shading under the lamps of the room, one
/// shadow ray a pixel. Tiles are rendered in parallel; the pixels do not depend on the number of
/// threads.
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

  RenderedView render(const Camera& camera, const Transform& T_world_camera) const;

  /// The same surfaces for other questions (visibility, clearance). Mesh i < objects.size() is
  /// object i, then come the drawn parts of the structure.
  const class Raycaster& raycaster() const;
  /// What mesh i of the raycaster looks like.
  const class DrawnMesh& mesh(std::size_t index) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace hydrabench

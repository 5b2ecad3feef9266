// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/simulation/placed_shape.h"

#include <map>

#include <fmt/format.h>

#include "core/parallel/parallel_for.h"
#include "eval/simulation/surface_mesher.h"

namespace hydrabench {

std::shared_ptr<const Surface> surfaceOf(const ShapeInstance& shape) {
  SurfaceMesh meshed = meshInstance(shape);
  auto surface = std::make_shared<Surface>();
  surface->mesh = std::move(meshed.mesh);
  surface->face_material = std::move(meshed.face_part);
  for (const ShapePart& part : shape.parts) surface->materials.push_back(part.material);
  return surface;
}

void appendShapes(const std::vector<PlacedShape>& placed, Scene& scene) {
  // Desks of one island share their shape, and so their mesh.
  std::vector<std::size_t> same_as(placed.size());
  for (std::size_t i = 0; i < placed.size(); ++i) {
    same_as[i] = 0;
    while (placed[same_as[i]].shape != placed[i].shape) ++same_as[i];
  }
  std::vector<std::shared_ptr<const Surface>> surfaces(placed.size());
  parallelFor(placed.size(), [&](std::size_t i) {
    if (same_as[i] == i) surfaces[i] = surfaceOf(*placed[i].shape);
  });
  std::map<Label, int> counts;
  for (std::size_t i = 0; i < placed.size(); ++i) {
    const PlacedShape& item = placed[i];
    const LabelSpace::Entry* entry = scene.label_space.find(item.label);
    SceneObject object;
    object.name =
        fmt::format("{}_{:03d}", scene.label_space.nameOf(item.label), ++counts[item.label]);
    object.subtype = item.shape->family;
    object.room = item.room;
    object.label = item.label;
    object.scored = entry && entry->is_scored;
    object.T_world_object = item.T_world_object;
    object.surface = surfaces[same_as[i]];
    object.shape = item.shape;
    scene.objects.push_back(std::move(object));
  }
}

}  // namespace hydrabench

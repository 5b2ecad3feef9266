// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/simulation/scene.h"

#include <array>
#include <cassert>

namespace hydrabench {
namespace {

Mesh coloured(const Surface& surface) {
  Mesh mesh = surface.mesh;
  if (surface.materials.empty()) {
    if (mesh.colors.empty()) mesh.colors.assign(mesh.vertices.size(), Rgb{160, 160, 160});
    return mesh;
  }
  mesh.colors.assign(mesh.vertices.size(), surface.materials.front().color);
  for (std::size_t i = 0; i < surface.face_material.size(); ++i) {
    const Rgb color = surface.materials[surface.face_material[i]].color;
    for (const int vertex : mesh.faces[i]) mesh.colors[static_cast<std::size_t>(vertex)] = color;
  }
  return mesh;
}

}  // namespace

Aabb worldBounds(const SceneObject& object) {
  Aabb box;
  for (const Eigen::Vector3d& vertex : object.surface->mesh.vertices) {
    box.extend(object.T_world_object * vertex);
  }
  return box;
}

Aabb bounds(const Scene& scene) {
  Aabb box;
  for (const SceneObject& object : scene.objects) box.extend(worldBounds(object));
  for (const StructurePart& part : scene.structure) box.extend(bounds(part.surface.mesh));
  return box;
}

Mesh mergedMesh(const Scene& scene, bool with_overhead, std::vector<Label>* labels) {
  Mesh whole;
  const auto add = [&](const Mesh& part, Label label) {
    append(part, whole);
    if (labels) labels->resize(whole.faces.size(), label);
  };
  if (labels) labels->clear();
  for (const StructurePart& part : scene.structure) {
    if (with_overhead || !part.overhead) add(coloured(part.surface), part.label);
  }
  for (const SceneObject& object : scene.objects) {
    add(transformed(object.T_world_object, coloured(*object.surface)), object.label);
  }
  return whole;
}

void appendBox(const Aabb& box, std::uint16_t material, Surface& surface, unsigned faces) {
  // Corner k has its x, y, z bit in bit 0, 1, 2. Quads are counter-clockwise seen from outside.
  static constexpr std::array<std::array<int, 4>, 6> kQuads = {
      {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}}};
  assert(surface.face_material.size() == surface.mesh.faces.size());
  for (unsigned side = 0; side < 6; ++side) {
    if (!(faces & (1u << side))) continue;
    const int first = static_cast<int>(surface.mesh.vertices.size());
    for (const int corner : kQuads[side]) {
      surface.mesh.vertices.emplace_back(corner & 1 ? box.max().x() : box.min().x(),
                                         corner & 2 ? box.max().y() : box.min().y(),
                                         corner & 4 ? box.max().z() : box.min().z());
    }
    surface.mesh.faces.emplace_back(first, first + 1, first + 2);
    surface.mesh.faces.emplace_back(first, first + 2, first + 3);
    surface.face_material.insert(surface.face_material.end(), 2, material);
  }
}

}  // namespace hydrabench

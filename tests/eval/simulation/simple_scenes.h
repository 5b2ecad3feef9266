// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <string>

#include "eval/simulation/office_labels.h"
#include "eval/simulation/scene.h"

namespace hydrabench {

inline StructurePart structureBox(const std::string& name, Label label, const Aabb& box) {
  StructurePart part;
  part.name = name;
  part.label = label;
  part.surface.materials = {{{180, 180, 180}, {180, 180, 180}, Material::Pattern::kPlain, 1, 0}};
  appendBox(box, 0, part.surface);
  return part;
}

inline SceneObject boxObject(const std::string& name, Label label,
                             const Eigen::Vector3d& dimensions,
                             const Eigen::Vector3d& bottom_center) {
  auto surface = std::make_shared<Surface>();
  surface->materials = {{{200, 60, 40}, {200, 60, 40}, Material::Pattern::kPlain, 1, 0}};
  const Eigen::Vector3d half(dimensions.x() / 2, dimensions.y() / 2, 0);
  appendBox({-half, Eigen::Vector3d(half.x(), half.y(), dimensions.z())}, 0, *surface);
  SceneObject object;
  object.name = name;
  object.label = label;
  object.scored = true;
  object.surface = surface;
  object.T_world_object.translation() = bottom_center;
  return object;
}

/// Two rooms of 4 x 4 m side by side (x from 0 to 4 and from 4.2 to 8.2) with a door of 1 m between
/// them, one box in each.
inline Scene twoRooms() {
  Scene scene;
  scene.label_space = officeLabelSpace(false);
  const auto wall = [&](double x0, double y0, double x1, double y1) {
    scene.structure.push_back(structureBox(
        "wall", office_label::kWall, {Eigen::Vector3d(x0, y0, 0), Eigen::Vector3d(x1, y1, 2.5)}));
  };
  scene.structure.push_back(
      structureBox("floor", office_label::kFloor,
                   {Eigen::Vector3d(-0.2, -0.2, -0.1), Eigen::Vector3d(8.4, 4.2, 0)}));
  wall(-0.2, -0.2, 8.4, 0);
  wall(-0.2, 4, 8.4, 4.2);
  wall(-0.2, 0, 0, 4);
  wall(8.2, 0, 8.4, 4);
  wall(4, 0, 4.2, 1.5);
  wall(4, 2.5, 4.2, 4);
  scene.rooms = {{"left", {Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(4, 4, 2.5)}},
                 {"right", {Eigen::Vector3d(4.2, 0, 0), Eigen::Vector3d(8.2, 4, 2.5)}}};
  scene.lamps = {{{2, 2, 2.4}, 4, 0}, {{6.2, 2, 2.4}, 4, 1}};
  scene.objects.push_back(boxObject("chair_001", office_label::kChair, {0.5, 0.5, 0.9}, {2, 2, 0}));
  scene.objects.push_back(
      boxObject("couch_001", office_label::kCouch, {0.8, 1.6, 0.8}, {7.5, 2, 0}));
  return scene;
}

}  // namespace hydrabench

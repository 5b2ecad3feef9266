// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "eval/simulation/scene.h"

namespace hydrabench {

/// An instance of a shape family somewhere in a world, not meshed yet.
struct PlacedShape {
  std::shared_ptr<const ShapeInstance> shape;
  Label label = kUnknownLabel;
  std::string room;  ///< room or district it stands in; may be empty
  Transform T_world_object = Transform::Identity();
};

/// Mesh and materials of an instance, object frame.
std::shared_ptr<const Surface> surfaceOf(const ShapeInstance& shape);

/// Meshes all instances (each shape once) and appends them to the scene in their order, with names
/// counted per class ("chair_007"). Objects are scored where the scene's label space says so.
void appendShapes(const std::vector<PlacedShape>& placed, Scene& scene);

}  // namespace hydrabench

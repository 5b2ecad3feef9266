// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/geometry/mesh.h"
#include "core/geometry/pose_interpolation.h"
#include "core/types/label_space.h"
#include "eval/datasets/dataset.h"
#include "eval/simulation/shape_family.h"

namespace hydrabench {

/// A triangle mesh and what it looks like. Textures are evaluated at the coordinates of the mesh's
/// own frame.
struct Surface {
  Mesh mesh;
  std::vector<Material> materials;  ///< empty: the vertex colours, or grey where there are none
  std::vector<std::uint16_t> face_material;  ///< index into materials per face; empty: 0 for all
};

/// A thing that can be told apart from its surroundings: it carries an instance id in every frame.
struct SceneObject {
  std::string name;     ///< "chair_007"
  std::string subtype;  ///< shape family, e.g. "office_chair_arms"
  std::string room;
  Label label = kUnknownLabel;
  bool scored = false;
  Transform T_world_object = Transform::Identity();
  std::shared_ptr<const Surface> surface;  ///< object frame
  std::shared_ptr<const ShapeInstance>
      shape;  ///< its exact distance field; null for meshes from files
};

/// Floor, wall, ceiling, door, window: labelled, but without an instance.
struct StructurePart {
  std::string name;
  Label label = kUnknownLabel;
  Surface surface;        ///< world frame
  bool overhead = false;  ///< hides the rooms from above: left out of overview pictures
  bool emissive = false;  ///< drawn in its own colour whatever the light
};

struct Lamp {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();  ///< world frame [m]
  double intensity = 1;  ///< irradiance at 1 m, 1 being white on white
  int room = -1;         ///< index into rooms; lights that room only. -1: all
};

/// Daylight: parallel light with hard shadows and an even sky.
struct Sun {
  Eigen::Vector3d to_sun = Eigen::Vector3d::UnitZ();  ///< unit vector, world frame
  double intensity = 0.8;  ///< irradiance on a surface that faces it, 1 being white on white
  double sky = 0.4;        ///< on a surface that faces up, without the sun
};

/// A thing that moves through the world: rigid parts, each on a path of its own. It carries an
/// instance id in every frame, as objects do, but belongs to no ground truth.
struct Mover {
  struct Part {
    std::shared_ptr<const Surface> surface;  ///< frame of the part
    std::vector<TimedPose> poses;            ///< T_world_part; not there before or after them
  };
  std::string name;  ///< "car_moving_001"
  Label label = kUnknownLabel;
  std::vector<Part> parts;
};

/// A world: what the sensors look at. Made by a generator (office, campus) or from mesh files. All
/// of it stands still but the movers.
struct Scene {
  LabelSpace label_space;
  std::vector<SceneObject> objects;
  std::vector<StructurePart> structure;
  std::vector<Mover> movers;
  std::vector<Lamp> lamps;
  std::optional<Sun> sun;  ///< lights in place of the lamps; none indoors
  std::vector<Room> rooms;
};

Aabb worldBounds(const SceneObject& object);
Aabb bounds(const Scene& scene);  ///< of what stands still

/// Everything that stands still in one mesh, world frame, vertices coloured by material.
/// @param labels  receives the class of every face; may be null
Mesh mergedMesh(const Scene& scene, bool with_overhead = true,
                std::vector<Label>* labels = nullptr);

/// Cuboid faces to add to a surface; internal faces can be left out so that touching boxes form one
/// skin.
enum BoxFaces : unsigned {
  kFaceXLow = 1,
  kFaceXHigh = 2,
  kFaceYLow = 4,
  kFaceYHigh = 8,
  kFaceZLow = 16,
  kFaceZHigh = 32,
  kAllFaces = 63
};
void appendBox(const Aabb& box, std::uint16_t material, Surface& surface,
               unsigned faces = kAllFaces);

}  // namespace hydrabench

// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "core/geometry/mesh.h"
#include "core/types/random.h"

namespace hydrabench {

/// A node of a signed-distance tree. Negative inside. Lipschitz with constant 1, so that |value| bounds the distance to the surface.
class Sdf {
 public:
  virtual ~Sdf() = default;
  virtual double value(const Eigen::Vector3d& p) const = 0;
  virtual Aabb bounds() const = 0;
};
using SdfPtr = std::shared_ptr<const Sdf>;

/// What a surface looks like; procedural textures are evaluated at object coordinates.
struct Material {
  enum class Pattern { kPlain, kNoise, kWood, kStripes, kTiles, kLeaves, kFabric, kScreen };
  Rgb color;
  Rgb second_color;
  Pattern pattern = Pattern::kPlain;
  double pattern_size_m = 0.1;
};

/// A part of one material. The object is the union of its parts; the material of a surface point is that of the nearest part.
struct ShapePart {
  SdfPtr sdf;
  Material material;
};

/// One object of a family with its own proportions. Object frame: origin on the floor below the centre of the footprint, z up, x to
/// the front (the way a person on the chair or couch looks; the side of a screen or a dispenser's tap).
struct ShapeInstance {
  std::string family;
  std::vector<ShapePart> parts;
  SdfPtr sdf;          ///< union of the parts
  int yaw_symmetry = 1;  ///< looks the same every 360/n degrees; 0: for any yaw
};

/// A parametric family of shapes. `size` classes (small, large) and styles are families of their own.
struct ShapeFamily {
  std::string name;        ///< "office_chair_arms"
  std::string class_name;  ///< "chair"
  ShapeInstance (*draw)(Random random);
  ShapeInstance (*nominal)();  ///< all parameters at the middle of their range: the canonical template of the family
};

/// Every family, indoor and (issue E) outdoor, in fixed order.
const std::vector<ShapeFamily>& shapeFamilies();
const ShapeFamily& shapeFamily(const std::string& name);  ///< aborts for an unknown name

struct SurfaceMesh {
  Mesh mesh;                             ///< watertight; vertices on the zero set; float-exact coordinates
  std::vector<std::uint16_t> face_part;  ///< index into parts, per face
};
/// Mesh of the zero set at a resolution fit for the instance's thinnest parts, decimated where flat.
SurfaceMesh meshInstance(const ShapeInstance& instance);

}  // namespace hydrabench

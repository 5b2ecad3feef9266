// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "core/geometry/mesh.h"
#include "core/types/random.h"
#include "eval/simulation/material.h"
#include "eval/simulation/sdf.h"

namespace hydrabench {

/// A part of one material. The object is the union of its parts; the material of a surface point is
/// that of the nearest part.
struct ShapePart {
  SdfPtr sdf;
  Material material;
};

/// One object of a family with its own proportions. Object frame: origin on the floor below the
/// centre of the footprint (of the foot, where a crown or a lamp's arm reaches out), z up, x to the
/// front (the way a person on the chair, the bench or at the wheel looks; the side of a screen, a
/// dispenser's tap, a hydrant's largest outlet or a sign's face).
struct ShapeInstance {
  std::string family;
  std::vector<ShapePart> parts;
  SdfPtr sdf;                  ///< union of the parts
  int yaw_symmetry = 1;        ///< looks the same every 360/n degrees; 0: for any yaw
  double thinnest_m = 0.02;    ///< smallest thickness of any part: what the mesh must resolve
  double max_pitch_m = 0.014;  ///< coarsest grid of the mesh: small next to what is rounded
};

/// A parametric family of shapes. `size` classes (small, large) and styles are families of their
/// own.
struct ShapeFamily {
  std::string name;                      ///< "office_chair_arms"
  std::string class_name;                ///< "chair"
  ShapeInstance (*draw)(Random random);  ///< a function of the random stream alone
  ShapeInstance (*nominal)();  ///< all parameters at the middle of their range: the canonical
                               ///< template of the family
};

/// Every family in fixed order: those of rooms, then those of streets.
const std::vector<ShapeFamily>& shapeFamilies();
/// Grouped by class: chair, couch, plant, bin, computer, then unscored furniture.
std::span<const ShapeFamily> indoorFamilies();
/// Grouped by class: fire_hydrant, car, bench, then unscored: tree, pole, bollard, sign.
std::span<const ShapeFamily> outdoorFamilies();
const ShapeFamily& shapeFamily(const std::string& name);  ///< aborts for an unknown name

struct SurfaceMesh {
  Mesh mesh;  ///< watertight; vertices on the zero set; float-exact coordinates
  std::vector<std::uint16_t> face_part;  ///< index into parts, per face
};
/// Mesh of the zero set at a resolution fit for the instance's thinnest parts, decimated where
/// flat; face edges follow the borders between materials. Closed, oriented, manifold, one piece.
SurfaceMesh meshInstance(const ShapeInstance& instance);

/// Instances for training, for validation and for evaluation never share a seed: the split is the
/// top two bits of the seed, the index the other 62 (more than that aborts). Draw with
/// `family.draw(Random(instanceSeed(split, index)))`.
enum class InstanceSplit : std::uint8_t { kEvaluation = 0, kTraining = 1, kValidation = 2 };
inline constexpr std::uint64_t kMaxInstanceIndex = (std::uint64_t{1} << 62) - 1;
std::uint64_t instanceSeed(InstanceSplit split, std::uint64_t index);
/// An index within the range, scattered over all of it: for worlds that number their objects by
/// (world seed, object number).
constexpr std::uint64_t instanceIndex(std::uint64_t world_seed, std::uint64_t object_number) {
  return hashSeed(world_seed, object_number) & kMaxInstanceIndex;
}

}  // namespace hydrabench

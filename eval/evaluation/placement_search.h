// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/geometry/transform.h"
#include "core/types/ids.h"

namespace hydrabench {

/// What the search knows of an object; coordinates of an estimate are whatever its file holds.
struct PlacedObject {
  Label label = kUnknownLabel;
  Eigen::Vector3d center = Eigen::Vector3d::Zero();
  double half_diagonal = 0;  ///< 0: size unknown
};

/// One change of coordinates that brings a whole prediction onto the ground truth:
/// world = linear * p + offset, in metres.
struct Placement {
  enum class Frame { kWorld, kFirstCamera, kFirstHeading };
  double unit_m = 1;                                   ///< metres per unit of the prediction
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();  ///< signed permutation; mirrors included
  Eigen::Vector3d offset = Eigen::Vector3d::Zero();    ///< [m]
  bool moved = false;                                  ///< the offset is part of the mistake
  bool doubled_positions = false;  ///< centres at twice their place, sizes as they should be
  Frame frame = Frame::kWorld;     ///< start of the sequence: camera, or level with its heading
  Eigen::Matrix3d T_rotation = Eigen::Matrix3d::Identity();  ///< of that frame in the world

  Eigen::Matrix3d linear() const;
};

struct Misplacement {
  Placement placement;
  std::size_t matches = 0;        ///< pairs that agree after the change
  std::size_t matches_as_is = 0;  ///< pairs that agree without it
  std::size_t possible = 0;       ///< sum over classes of min(estimates, ground truth)
};

/// Looks for a mistake of the whole prediction: millimetres, centimetres or kilometres for metres;
/// one of the 47 other ways to name and sign three axes; another origin; the frame of the first
/// camera, or of the start pose; positions doubled; and unit, axes and origin wrong together. A
/// frame of its own per object or per frame is not recognisable and not looked for.
///
/// Two objects of a class agree where they are each other's nearest and closer than
/// max(0.2 m, half the half-diagonal of the true one). A bad but honest method must not be accused,
/// so a mistake is claimed only if the changed prediction agrees
///  - three times as often as the given one, which may itself be moved by up to 1 m or one object's
///    diagonal, because methods that see one side of things are off by a constant;
///  - in at least 6 pairs and a third of those possible. Where the origin is free, which finds
///    coincidences in any layout, in at least 8 and half of those possible, and 1.5 times as often
///    as about any other origin (rows of equal desks fit when moved by one desk);
///  - beyond chance: how often wrong offsets agree gives the chance of one pair; the binomial tail
///    times the number of changes tried must be below 1e-4.
/// Simpler changes win over combined ones unless those agree 1.5 times as often. nullopt: as it
/// should be, or too bad or too small to tell.
/// @param T_world_first_camera  true pose at the start; nullopt where unknown
std::optional<Misplacement> findMisplacement(std::span<const PlacedObject> estimates,
                                             std::span<const PlacedObject> truths,
                                             const std::optional<Transform>& T_world_first_camera);

}  // namespace hydrabench

// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <string>

#include "core/types/random.h"
#include "eval/datasets/dataset.h"

namespace hydrabench {

inline constexpr Label kChair = 5;
inline constexpr Label kCouch = 7;
inline constexpr Label kBin = 18;
inline constexpr Label kDesk = 16;

/// Chair, couch and bin are scored, desk is not.
inline LabelSpace furnitureLabels() {
  LabelSpace space;
  space.entries = {{kChair, "chair", {}, true, true},
                   {kCouch, "couch", {}, true, true},
                   {kBin, "bin", {}, true, true},
                   {kDesk, "desk", {}, true, false}};
  return space;
}

/// A box that stands on the floor at (x, y).
inline GroundTruthObject standingBox(ObjectId id, Label label, double x, double y,
                                     const Eigen::Vector3d& size) {
  GroundTruthObject object;
  object.id = id;
  object.label = label;
  object.name = "object_" + std::to_string(id);
  object.T_world_object.translation() = Eigen::Vector3d(x, y, 0);
  object.mesh = std::make_shared<const Mesh>(
      boxMesh(Aabb(Eigen::Vector3d(-size.x() / 2, -size.y() / 2, 0),
                   Eigen::Vector3d(size.x() / 2, size.y() / 2, size.z()))));
  return object;
}

/// Twelve chairs, six couches and six bins, anywhere in 20 x 14 m; a world for every seed.
inline GroundTruth scatteredWorld(std::uint64_t seed = 1) {
  Random random(seed);
  GroundTruth truth;
  for (ObjectId i = 0; i < 24; ++i) {
    const Label label = i < 12 ? kChair : i < 18 ? kCouch : kBin;
    const Eigen::Vector3d size = label == kChair   ? Eigen::Vector3d(0.6, 0.6, 0.9)
                                 : label == kCouch ? Eigen::Vector3d(2.0, 0.9, 0.8)
                                                   : Eigen::Vector3d(0.3, 0.3, 0.4);
    truth.objects.push_back(
        standingBox(i, label, random.uniform(0, 20), random.uniform(0, 14), size));
  }
  return truth;
}

}  // namespace hydrabench

// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include "core/types/frame.h"
#include "eval/datasets/dataset.h"

namespace hydrabench {

inline constexpr Label kChairLabel = 5;
inline constexpr Label kBinLabel = 18;

/// A chair of 1 x 1 x 2 m to the left of the camera and a bin, a cube of 1 m, to its right; their
/// front faces stand 3 m before the camera, which is at the origin and looks along x. A plate hides
/// the lower half of the bin.
inline GroundTruth twoBoxes() {
  GroundTruth truth;
  const auto add = [&](Label label, const char* name, const Eigen::Vector3d& place,
                       const Eigen::Vector3d& size) {
    GroundTruthObject object;
    object.id = truth.objects.size() + 1;
    object.label = label;
    object.name = name;
    object.T_world_object.translation() = place;
    // Object frames stand on the floor.
    object.mesh = std::make_shared<const Mesh>(
        boxMesh(Aabb(Eigen::Vector3d(-size.x() / 2, -size.y() / 2, 0),
                     Eigen::Vector3d(size.x() / 2, size.y() / 2, size.z()))));
    append(transformed(object.T_world_object, *object.mesh), truth.scene_mesh);
    truth.objects.push_back(object);
  };
  add(kChairLabel, "chair_000", {3.5, 1, -1}, {1, 1, 2});
  add(kBinLabel, "bin_000", {3.5, -1, -0.5}, {1, 1, 1});
  append(boxMesh(Aabb(Eigen::Vector3d(2, -2, -1), Eigen::Vector3d(2.1, 0, 0))), truth.scene_mesh);
  truth.trajectory.push_back({7, lookAt(Eigen::Vector3d::Zero(), Eigen::Vector3d(1, 0, 0))});
  return truth;
}

/// 60 x 60 pixels; a metre at 3 m depth is 20 pixels wide.
inline Camera smallCamera() { return {60, 60, 60, 60, 29.5, 29.5}; }

inline std::uint32_t pixelAt(int u, int v) { return static_cast<std::uint32_t>(v * 60 + u); }

/// The stamp and pose of twoBoxes(), nothing measured, one mask.
inline Frame smallFrame() {
  Frame frame;
  frame.stamp_ns = 7;
  frame.camera = smallCamera();
  frame.T_world_camera = twoBoxes().trajectory.front().T_world_camera;
  frame.labels = Image<Label>(60, 60);
  frame.instances = Image<InstanceId>(60, 60);
  return frame;
}

}  // namespace hydrabench

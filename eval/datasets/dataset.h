// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/geometry/mesh.h"
#include "core/types/frame.h"
#include "core/types/label_space.h"

namespace hydrabench {

/// An object as it truly is.
struct GroundTruthObject {
  ObjectId id = 0;
  Label label = kUnknownLabel;
  std::string name;     ///< "chair_007"
  std::string subtype;  ///< "office_chair_arms"; empty where unknown
  std::string room;     ///< "meeting_1"; empty where unknown
  Transform T_world_object = Transform::Identity();
  std::shared_ptr<const Mesh>
      mesh;  ///< object frame [m]; exact in float, which is what mesh files hold
  double visible_fraction =
      1;               ///< share of the surface that some frame of the sequence saw, in [0, 1]
  bool scored = true;  ///< false: neither a hit nor a miss counts (furniture, structure)
};

struct Room {
  std::string name;
  Aabb box;
};

struct StampedPose {
  std::int64_t stamp_ns = 0;
  Transform T_world_camera = Transform::Identity();
};

struct GroundTruth {
  std::vector<GroundTruthObject> objects;
  Mesh scene_mesh;                  ///< world frame: everything, objects included; exact in float
  std::vector<Label> scene_labels;  ///< per face of scene_mesh; empty where unknown
  std::vector<Room> rooms;          ///< empty where unknown
  std::vector<StampedPose> trajectory;  ///< without odometry drift
};

/// A sequence of frames with ground truth. Frames are made or read one at a time: a sequence never
/// has to fit into memory. Frames may be asked for in any order, from several threads at once, and
/// give the same bytes each time.
class Dataset {
 public:
  virtual ~Dataset() = default;
  virtual std::string name() const = 0;
  virtual std::uint64_t seed() const { return 0; }  ///< of a generated world; 0 for recordings
  virtual const LabelSpace& labelSpace() const = 0;
  virtual const Camera& camera() const = 0;
  virtual std::size_t numFrames() const = 0;
  virtual Frame frame(std::size_t index) const = 0;  ///< throws InputError naming the file at fault
  /// What the evaluation compares with. Never handed to a method.
  virtual const GroundTruth& groundTruth() const = 0;
  /// False where the dataset has no trustworthy objects to score against (real recordings).
  virtual bool hasGroundTruth() const { return true; }
};

}  // namespace hydrabench

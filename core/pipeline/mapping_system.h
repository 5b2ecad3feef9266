// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "core/graph/scene_graph.h"
#include "core/graph/shape_candidate.h"
#include "core/pipeline/stage_times.h"
#include "core/types/frame.h"

namespace hydrabench {

/// A method: frames in, a scene graph out. What it may know is the frame and, from its constructor,
/// its config and the label space of the dataset; never ground truth.
class MappingSystem {
 public:
  virtual ~MappingSystem() = default;
  /// Frames come in order of their stamps.
  virtual void process(const Frame& frame) = 0;
  /// The end of the sequence: everything still open is closed. Once, and no frame after it.
  virtual SceneGraph finish() = 0;
  /// Time per stage so far. A stage is a part of process() or finish(), under a name of its own;
  /// process() and finish() as a whole are timed by the caller, as "frame" and "finish".
  virtual const StageTimes& stageTimes() const = 0;
  /// Remarks a reader of the table must know, e.g. a rule that the method's authors left open.
  virtual std::vector<std::string> notes() const { return {}; }
  /// Hands over the record of every shape that was estimated, accepted or not; after finish().
  virtual std::vector<ShapeCandidate> takeCandidates() { return {}; }
};

}  // namespace hydrabench

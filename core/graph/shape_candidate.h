// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

#include "core/geometry/box.h"
#include "core/geometry/camera.h"
#include "core/geometry/mesh.h"
#include "core/geometry/transform.h"
#include "core/types/ids.h"
#include "core/types/image.h"

namespace hydrabench {

/// A shape that was estimated for a track, or the reason why there is none, with all that a
/// decision about it needs: thresholds and merging can be redone without mapping again
/// (core/pipeline/candidate_decision.h), and the view can be drawn with it.
struct ShapeCandidate {
  std::uint64_t track = 0;  ///< ascending within a run
  Label label = kUnknownLabel;
  std::int64_t first_observed_ns = 0;
  std::int64_t last_observed_ns = 0;
  std::size_t observations = 0;

  // The view that the shape was estimated from.
  std::int64_t view_stamp_ns = 0;
  Camera camera;
  Transform T_world_camera = Transform::Identity();
  double view_volume_m3 = 0;  ///< of the box around the observed points
  int mask_u = 0;             ///< pixel of the camera that the first pixel of `mask` is
  int mask_v = 0;
  Image<std::uint8_t> mask;  ///< 1 on the object; cut out around it

  // The estimate. Without one `failure` says why and the rest is meaningless.
  std::string failure;
  Transform T_world_object = Transform::Identity();
  double scale = 1;
  Mesh mesh;  ///< world [m], scaled and placed; its vertices are floats, so that files lose nothing
  Aabb box;   ///< of the mesh
  double inlier_ratio = 1;
  double overlap = 0;  ///< scores of the check, see core/objects/rmcc.h
  double coverage = 0;
  std::optional<double> depth_residual_m;

  /// What was seen of the object, fused (world [m], floats); empty unless asked for.
  Mesh partial_mesh;

  // What was decided.
  bool accepted = false;
  std::string reason;              ///< of a rejection, "failure: ..." for one without estimate
  std::optional<ObjectId> object;  ///< the node it became or was merged into

  bool hasEstimate() const { return failure.empty(); }
};

}  // namespace hydrabench

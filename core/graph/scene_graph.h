// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/geometry/mesh.h"
#include "core/geometry/transform.h"
#include "core/graph/shape_candidate.h"
#include "core/types/ids.h"
#include "core/types/label_space.h"

namespace hydrabench {

/// An object of a 3-D scene graph: label l, scale s, mesh, position and rotation (paper, eq. 4).
struct ObjectNode {
  ObjectId id = 0;
  Label label = kUnknownLabel;
  std::string name;
  Transform T_world_object = Transform::Identity();
  double scale = 1;  ///< metric size of the canonical shape; 1 where the method has no such notion.
                     ///< Already applied to `mesh`.
  Mesh mesh;         ///< world frame [m]. May be empty: then `box` is all there is.
  Aabb box;          ///< world frame; the box of the mesh where there is one
  std::int64_t first_observed_ns = 0;
  std::int64_t last_observed_ns = 0;
};

struct SceneGraph {
  LabelSpace label_space;
  std::vector<ObjectNode> objects;
  Mesh scene_mesh;                  ///< world frame [m]; may be empty
  std::vector<Label> scene_labels;  ///< per vertex of scene_mesh, or empty
  /// Centres of the voxels that the map takes for solid, world frame [m]; empty where the method
  /// does not keep them, see ActiveWindow::Config::keep_occupied.
  std::vector<Eigen::Vector3f> occupied;
  double occupied_voxel_m = 0;  ///< side of those voxels
};

/// What a mapping system leaves behind, and what evaluation reads.
struct Prediction {
  SceneGraph graph;
  std::string method;              ///< name of the method that made it, as it appears in tables
  std::vector<std::string> notes;  ///< what a reader of the table must know of the method
  std::vector<ShapeCandidate> candidates;  ///< of a method that estimates shapes
};

}  // namespace hydrabench

// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "core/graph/scene_graph.h"
#include "metrics/detection.h"

namespace hydrabench {

/// A prediction spoilt in a known way, with what detection must see of it: worked out from the
/// centres of the objects before, never from the meshes after.
struct DamagedPrediction {
  Prediction prediction;
  std::vector<DetectionObject> estimates;  ///< one per node, in order; half diagonals are not set
};

/// world = linear * p + offset for every vertex. `linear` maps boxes to boxes: a signed permutation
/// times a factor. Winding is left as it is, so a mirror turns closed meshes inside out.
struct CoordinateChange {
  Eigen::Matrix3d linear = Eigen::Matrix3d::Identity();
  Eigen::Vector3d offset = Eigen::Vector3d::Zero();
};
DamagedPrediction changed(const Prediction& prediction, const CoordinateChange& change);

/// No object at all.
DamagedPrediction emptied(const Prediction& prediction);

/// Every node a second time under another id.
DamagedPrediction doubled(const Prediction& prediction);

/// In each class the two nodes whose centres are closest become one, with both meshes; it stands
/// where the first stood in the list. Classes of one object stay as they are.
struct MergedPrediction : DamagedPrediction {
  struct Join {
    std::size_t node = 0;                  ///< index of the joint node
    std::array<DetectionObject, 2> parts;  ///< as they were
  };
  std::vector<Join> joins;
};
MergedPrediction merged(const Prediction& prediction);

/// The corners of every face in the opposite order.
DamagedPrediction turnedInsideOut(const Prediction& prediction);

/// One coordinate of one vertex of one node is not a number. Needs a node with a mesh.
Prediction withNan(const Prediction& prediction, std::size_t node);

}  // namespace hydrabench

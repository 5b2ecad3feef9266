// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <vector>

#include <Eigen/Core>

#include "core/geometry/box.h"

namespace hydrabench {

/// A node of a signed-distance tree. Negative inside. Lipschitz with constant 1, so that |value|
/// never exceeds the distance to the surface: empty space may be skipped by it.
class Sdf {
 public:
  virtual ~Sdf() = default;
  virtual double value(const Eigen::Vector3d& p) const = 0;  ///< [m]
  virtual Aabb bounds() const = 0;                           ///< contains the shape; may be loose
  /// The members this node is a plain union of (all levels); the node itself where it is none.
  virtual void collectMembers(std::vector<const Sdf*>& members) const { members.push_back(this); }
};
using SdfPtr = std::shared_ptr<const Sdf>;

/// Unit gradient by central differences: the outward normal near the surface.
Eigen::Vector3d sdfNormal(const Sdf& sdf, const Eigen::Vector3d& p);

}  // namespace hydrabench

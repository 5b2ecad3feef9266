// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include <Eigen/Core>

#include "core/geometry/mesh.h"

namespace hydrabench {

/// Generalised winding number of a triangle soup (Jacobson et al., ACM TOG 2013) by a hierarchy of
/// far-field dipoles (Barill et al., "Fast winding numbers for soups and clouds", ACM TOG 2018): 1
/// inside, 0 outside a closed mesh; between for open meshes.
class WindingNumber {
 public:
  explicit WindingNumber(const Mesh& mesh);
  ~WindingNumber();
  WindingNumber(WindingNumber&&) noexcept;
  WindingNumber& operator=(WindingNumber&&) noexcept;

  /// Error below about 1e-2 away from the surface; use exactAt where that is not enough.
  /// Thread-safe.
  double at(const Eigen::Vector3d& query) const;
  /// Sum over every triangle: the reference, O(faces).
  double exactAt(const Eigen::Vector3d& query) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace hydrabench

// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>

#include <Eigen/Core>

namespace hydrabench {

/// Plane of best fit of some points, in the sense of the least sum of squared distances (PCA).
struct Plane {
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();       ///< of the points [m]
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();    ///< unit, z >= 0
  Eigen::Vector3d variances = Eigen::Vector3d::Zero();  ///< of the points, descending [m^2], >= 0

  /// Above the plane: positive [m].
  double signedDistance(const Eigen::Vector3f& point) const {
    return normal.dot(point.cast<double>() - mean);
  }
  /// Variance along the normal [m^2]: Patchwork's flatness, smaller is flatter.
  double flatness() const { return variances.z(); }
  /// How much longer than wide the points lie, as a ratio of variances, >= 1; infinite where they
  /// lie on a line.
  double lineRatio() const;
};

/// Sums over points, from which their plane follows. The result depends on the order of points in
/// its last bits only.
class PlaneMoments {
 public:
  void add(const Eigen::Vector3f& point) {
    const Eigen::Vector3d p = point.cast<double>();
    sum_ += p;
    squares_ += p.cwiseProduct(p);
    products_ += Eigen::Vector3d(p.x() * p.y(), p.x() * p.z(), p.y() * p.z());
    ++count_;
  }
  std::size_t count() const { return count_; }
  /// Empty for fewer than three points. Covariances are divided by n - 1.
  std::optional<Plane> plane() const;

 private:
  Eigen::Vector3d sum_ = Eigen::Vector3d::Zero();
  Eigen::Vector3d squares_ = Eigen::Vector3d::Zero();   // xx, yy, zz
  Eigen::Vector3d products_ = Eigen::Vector3d::Zero();  // xy, xz, yz
  std::size_t count_ = 0;
};

}  // namespace hydrabench

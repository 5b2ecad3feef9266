// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "core/mapping/ground/plane.h"

#include <limits>

#include <Eigen/Eigenvalues>

namespace hydrabench {

double Plane::lineRatio() const {
  return variances.y() > 0 ? variances.x() / variances.y()
                           : std::numeric_limits<double>::infinity();
}

std::optional<Plane> PlaneMoments::plane() const {
  if (count_ < 3) return std::nullopt;
  const double n = static_cast<double>(count_);
  Plane plane;
  plane.mean = sum_ / n;
  const Eigen::Vector3d& m = plane.mean;
  const Eigen::Vector3d on = (squares_ - n * m.cwiseProduct(m)) / (n - 1);
  const Eigen::Vector3d off =
      (products_ - n * Eigen::Vector3d(m.x() * m.y(), m.x() * m.z(), m.y() * m.z())) / (n - 1);
  Eigen::Matrix3d covariance;
  covariance << on.x(), off.x(), off.y(),  //
      off.x(), on.y(), off.z(),            //
      off.y(), off.z(), on.z();
  // The iterative solver: the closed form loses the small eigenvalue of flat patches.
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(covariance);
  plane.variances = solver.eigenvalues().reverse().cwiseMax(0.0);
  plane.normal = solver.eigenvectors().col(0);
  if (plane.normal.z() < 0) plane.normal = -plane.normal;
  return plane;
}

}  // namespace hydrabench

// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "core/geometry/transform.h"

#include <algorithm>
#include <cmath>

#include <Eigen/SVD>
#include <fmt/format.h>

namespace hydrabench {

std::optional<Transform> rigidFromMatrix(const Eigen::Matrix4d& matrix, std::string* fault,
                                         double tolerance) {
  const auto fail = [&](std::string reason) {
    if (fault) *fault = std::move(reason);
    return std::nullopt;
  };
  if (!matrix.allFinite()) return fail("has a value that is not finite");
  const Eigen::RowVector4d bottom = matrix.row(3);
  if (!(bottom - Eigen::RowVector4d(0, 0, 0, 1)).isZero(tolerance)) {
    return fail(fmt::format("has the bottom row ({:g}, {:g}, {:g}, {:g}) instead of (0, 0, 0, 1)",
                            bottom(0), bottom(1), bottom(2), bottom(3)));
  }
  const Eigen::Matrix3d R = matrix.topLeftCorner<3, 3>();
  const double deviation = (R.transpose() * R - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff();
  if (!(deviation <= tolerance)) {
    return fail(fmt::format(
        "has a rotation that is not orthonormal (R^T R differs from 1 by {:.3g})", deviation));
  }
  if (R.determinant() < 0) return fail("has a mirrored rotation (determinant -1)");

  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(R, Eigen::ComputeFullU | Eigen::ComputeFullV);
  Transform transform = Transform::Identity();
  transform.linear() = svd.matrixU() * svd.matrixV().transpose();
  transform.translation() = matrix.topRightCorner<3, 1>();
  return transform;
}

double rotationAngle(const Eigen::Matrix3d& R_a, const Eigen::Matrix3d& R_b) {
  // |q - q'| and |q + q'| keep their digits near 0 and near pi, where the arc cosine of a trace
  // loses half of them.
  const Eigen::Quaterniond a(R_a);
  const Eigen::Quaterniond b(R_b);
  const double difference = (a.coeffs() - b.coeffs()).norm();
  const double sum = (a.coeffs() + b.coeffs()).norm();
  return 4.0 * std::atan2(std::min(difference, sum), std::max(difference, sum));
}

Transform interpolate(const Transform& from, const Transform& to, double fraction) {
  const Eigen::Quaterniond R_from(from.linear());
  const Eigen::Quaterniond R_to(to.linear());
  Transform result = Transform::Identity();
  result.linear() = R_from.slerp(fraction, R_to).normalized().toRotationMatrix();
  result.translation() = from.translation() + fraction * (to.translation() - from.translation());
  return result;
}

Transform lookAt(const Eigen::Vector3d& eye, const Eigen::Vector3d& target) {
  const Eigen::Vector3d forward = (target - eye).normalized();
  Eigen::Vector3d right = forward.cross(Eigen::Vector3d::UnitZ());
  // Straight up or down has no horizon: the world's y axis points up in the image.
  if (right.norm() < 1e-9) right = forward.cross(Eigen::Vector3d::UnitY());
  right.normalize();
  Transform T_world_camera = Transform::Identity();
  T_world_camera.linear().col(0) = right;
  T_world_camera.linear().col(1) = forward.cross(right);
  T_world_camera.linear().col(2) = forward;
  T_world_camera.translation() = eye;
  return T_world_camera;
}

}  // namespace hydrabench

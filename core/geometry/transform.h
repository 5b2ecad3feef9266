// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include <Eigen/Geometry>

namespace hydrabench {

/// Rigid motion. T_a_b takes coordinates in b to a: p_a = T_a_b * p_b.
using Transform = Eigen::Isometry3d;

/// The rigid motion in a 4 x 4 matrix, or nullopt with the reason in `fault` (non-finite, bottom
/// row, rotation not orthonormal within `tolerance`, mirrored). The rotation is projected onto
/// SO(3), so that text files with few digits do not scale anything.
std::optional<Transform> rigidFromMatrix(const Eigen::Matrix4d& matrix,
                                         std::string* fault = nullptr, double tolerance = 1e-3);

/// Angle between two rotations [rad], 0 to pi.
double rotationAngle(const Eigen::Matrix3d& R_a, const Eigen::Matrix3d& R_b);

/// Linear in translation, spherical-linear in rotation; fraction in [0, 1].
Transform interpolate(const Transform& from, const Transform& to, double fraction);

/// Camera pose (x right, y down, z forward) that looks from `eye` to `target`, with world z up in
/// the image.
Transform lookAt(const Eigen::Vector3d& eye, const Eigen::Vector3d& target);

}  // namespace hydrabench

// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "eval/datasets/dataset.h"

namespace hydrabench {

/// One pose T_world_camera a line, '#' starts a comment. By the number of columns:
///   13  stamp in ns, then the upper 3 x 4 of the matrix row by row (what we write: reads back
///   bit-equal)
///    8  stamp in s, tx ty tz qx qy qz qw (TUM)
/// Throws InputError (file:line) for anything else, a rotation that is not orthonormal, and stamps
/// that do not increase.
std::vector<StampedPose> readPoses(const std::filesystem::path& path);
void writePoses(const std::filesystem::path& path, const std::vector<StampedPose>& poses);

/// A 4 x 4 matrix of numbers separated by white space.
Transform readPoseMatrix(const std::filesystem::path& path);

/// A rotation that is orthonormal to rounding is kept as it is, to the bit; one from a text with
/// few digits is projected onto SO(3). Throws InputError beginning with `place` for anything that
/// is no rigid motion.
Transform checkedPose(const Eigen::Matrix4d& matrix, const std::string& place);

}  // namespace hydrabench

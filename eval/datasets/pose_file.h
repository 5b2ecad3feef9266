// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
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

/// One sweep of a LiDAR, and where the LiDAR was.
struct ScanPose {
  std::int64_t start_ns = 0;
  std::int64_t stamp_ns = 0;  ///< end
  Transform T_world_lidar_start = Transform::Identity();
  Transform T_world_lidar = Transform::Identity();
};

/// One sweep a line: start and end in ns, T_world_lidar at the start, at the end (3 x 4 each, 26
/// columns). Or a line of readPoses(), for sweeps that were measured at once.
std::vector<ScanPose> readScanPoses(const std::filesystem::path& path);
void writeScanPoses(const std::filesystem::path& path, const std::vector<ScanPose>& poses);

/// When something was measured.
struct Interval {
  std::int64_t start_ns = 0;
  std::int64_t stamp_ns = 0;  ///< end
};
/// One stamp, or start and end, a line: whole ns, or s with a decimal point. Ends increase.
std::vector<Interval> readStamps(const std::filesystem::path& path);

/// The poses of KITTI: a 3 x 4 matrix a line, no stamp. Line i is of frame i.
std::vector<Transform> readKittiPoses(const std::filesystem::path& path);

/// A 4 x 4 matrix of numbers separated by white space.
Transform readPoseMatrix(const std::filesystem::path& path);

/// A rotation that is orthonormal to rounding is kept as it is, to the bit; one from a text with
/// few digits is projected onto SO(3). Throws InputError beginning with `place` for anything that
/// is no rigid motion.
Transform checkedPose(const Eigen::Matrix4d& matrix, const std::string& place);

}  // namespace hydrabench

// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/config/config_reader.h"
#include "core/geometry/transform.h"
#include "eval/datasets/dataset.h"
#include "eval/datasets/pose_file.h"

namespace hydrabench {

/// How the sensors sit on the robot; needed where their poses come from odometry.txt.
struct Extrinsics {
  std::optional<Transform> T_body_camera;
  std::optional<Transform> T_body_lidar;
};
/// Keys T_body_camera and T_body_lidar, the upper 3 x 4 row by row. A fault for anything that is no
/// rigid motion.
Extrinsics readExtrinsics(ConfigReader& reader);

/// One sweep of the folder lidar/.
struct FolderScan {
  std::size_t file = 0;  ///< its number
  ScanPose pose;
};

/// When and where every frame and every sweep of a folder was taken (docs/datasets.md).
struct FolderPoses {
  std::vector<StampedPose> frames;
  std::vector<FolderScan> scans;
  std::vector<std::size_t> first_scan;  ///< of each frame, and one more: the end of the last
};

/// Frames are in poses.txt, or at the times in camera_stamps.txt along odometry.txt; sweeps in
/// lidar_poses.txt, or at those in lidar_stamps.txt along odometry.txt. Sweeps that odometry does
/// not cover from start to end are left out. Without a camera, every sweep is a frame.
/// Throws InputError, also where frames and sweeps have no time in common.
FolderPoses readFolderPoses(const std::filesystem::path& folder, bool has_camera, bool has_lidar,
                            const Extrinsics& extrinsics);

}  // namespace hydrabench

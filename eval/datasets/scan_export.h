// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <vector>

#include "core/types/frame.h"
#include "eval/datasets/lidar_files.h"
#include "eval/datasets/pose_file.h"

namespace hydrabench {

/// Writes the sweeps of a dataset into the folder lidar/ and lidar_poses.txt.
class ScanExport {
 public:
  ScanExport(std::filesystem::path folder, std::size_t num_frames);

  /// From any thread, each frame once.
  void write(std::size_t index, const Frame& frame);
  /// Once every frame is written: numbers the sweeps through. nullopt where there are none. Throws
  /// InputError where they are not of one sensor and one kind.
  std::optional<LidarDescription> finish();

 private:
  struct Written {
    std::filesystem::path stem;
    ScanPose pose;
    LidarDescription lidar;
    bool has_points = false;
  };
  std::filesystem::path folder_;
  std::vector<std::vector<Written>> frames_;
};

}  // namespace hydrabench

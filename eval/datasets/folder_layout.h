// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

#include <fmt/format.h>

namespace hydrabench::folder_layout {

// What the folder reader and the exporter must agree on; docs/datasets.md says it in words.

inline constexpr const char* kDescription = "dataset.yaml";
inline constexpr const char* kPoses = "poses.txt";
inline constexpr const char* kInstanceLabels = "instance_labels.csv";
inline constexpr const char* kInstanceLabelsHeader = "frame,instance,label";
inline constexpr const char* kGroundTruth = "ground_truth";
inline constexpr const char* kColor = "color";
inline constexpr const char* kDepth = "depth";
inline constexpr const char* kLabels = "labels";
inline constexpr const char* kInstances = "instances";
inline constexpr const char* kLidar = "lidar";
inline constexpr const char* kLidarPoses = "lidar_poses.txt";
inline constexpr const char* kOdometry = "odometry.txt";
inline constexpr const char* kCameraStamps = "camera_stamps.txt";
inline constexpr const char* kLidarStamps = "lidar_stamps.txt";
inline constexpr const char* kBodyCamera = "T_body_camera";
inline constexpr const char* kBodyLidar = "T_body_lidar";

/// "color/000042.png"
inline std::filesystem::path image(const char* kind, std::size_t frame, const char* extension) {
  return std::filesystem::path(kind) / fmt::format("{:06d}{}", frame, extension);
}

/// "lidar/000042", to which the extensions of a scan's files are added
inline std::filesystem::path scan(std::size_t number) { return image(kLidar, number, ""); }

}  // namespace hydrabench::folder_layout

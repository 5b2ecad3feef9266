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

/// "color/000042.png"
inline std::filesystem::path image(const char* kind, std::size_t frame, const char* extension) {
  return std::filesystem::path(kind) / fmt::format("{:06d}{}", frame, extension);
}

}  // namespace hydrabench::folder_layout

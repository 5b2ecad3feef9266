// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "core/config/config_reader.h"
#include "core/geometry/camera.h"
#include "core/types/label_space.h"
#include "eval/datasets/dataset.h"

namespace hydrabench {

/// A dataset as its config describes it, before a world is generated or a file read.
struct DatasetConfig {
  std::string name = {};
  std::uint64_t seed = 0;  ///< 0 for recordings
  bool generated = false;  ///< a world of the seed; otherwise files that are as they are
  std::vector<std::filesystem::path> files = {};        ///< and folders that it is made from
  std::function<std::unique_ptr<Dataset>()> open = {};  ///< throws InputError
  std::string resolved_config = {};                     ///< YAML with every key at its value
};

// Parts that the configs of several datasets share.

/// Section `camera`: width_px, height_px, fx_px, fy_px, cx_px, cy_px.
void readCamera(ConfigReader& reader, Camera& camera);
std::string cameraYaml(const Camera& camera);

/// List `label_space`: label, name, color [r, g, b], is_object, is_scored, is_ground.
void readLabelSpace(ConfigReader& reader, LabelSpace& label_space);
std::string labelSpaceYaml(const LabelSpace& label_space);

/// Key `root`: where data sets that are not part of the project lie. Empty: the environment
/// variable HYDRABENCH_DATA. A fault where neither names a folder that exists.
std::filesystem::path readDataRoot(ConfigReader& reader);

/// A fault at `key` where `folder` does not exist below a root that does.
void requireFolder(ConfigReader& reader, const char* key, const std::filesystem::path& root,
                   const std::filesystem::path& folder);

}  // namespace hydrabench

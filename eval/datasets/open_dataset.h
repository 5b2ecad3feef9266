// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "core/config/config_reader.h"
#include "eval/datasets/dataset.h"
#include "eval/datasets/dataset_config.h"

namespace hydrabench {

/// Reads a YAML file (configs/datasets/*.yaml), or the folder with one; its `type` picks the reader
/// from one table: simulated, folder, placed_meshes, mesh_gallery, seven_scenes, apc2016,
/// kitti_raw. `overrides` are key=value. Throws InputError.
DatasetConfig readDataset(const std::filesystem::path& config,
                          const std::vector<std::string>& overrides = {});
/// The same from a document in memory, such as a resolved config.
DatasetConfig readDataset(const ConfigDocument& document);

/// Reads and opens.
struct OpenedDataset {
  std::unique_ptr<Dataset> dataset;
  std::string resolved_config;
};
OpenedDataset openDataset(const std::filesystem::path& config,
                          const std::vector<std::string>& overrides = {});
OpenedDataset openDataset(const ConfigDocument& document);

}  // namespace hydrabench

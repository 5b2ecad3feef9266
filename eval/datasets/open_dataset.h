// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "core/config/config_reader.h"
#include "eval/datasets/dataset.h"

namespace hydrabench {

/// Opens the dataset a YAML file (configs/datasets/*.yaml) describes; its `type` picks the reader
/// from one table: simulated, folder, placed_meshes, mesh_gallery, seven_scenes,
/// apc2016. `overrides` are
/// key=value. Throws InputError.
struct OpenedDataset {
  std::unique_ptr<Dataset> dataset;
  std::string resolved_config;  ///< YAML with every key at its value
};
OpenedDataset openDataset(const std::filesystem::path& config,
                          const std::vector<std::string>& overrides = {});

/// The same from a document in memory, such as a resolved config. A folder dataset cannot be opened
/// so: its files stand beside the config.
OpenedDataset openDataset(const ConfigDocument& document);

}  // namespace hydrabench

// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <memory>

#include "core/config/config_reader.h"
#include "eval/datasets/dataset.h"
#include "eval/datasets/dataset_config.h"

namespace hydrabench {

// Datasets that are rendered (eval/simulation): the generated worlds, and worlds of mesh files seen
// through the same sensors.

DatasetConfig readSimulated(ConfigReader& reader, const std::filesystem::path& config);
DatasetConfig readPlacedMeshes(ConfigReader& reader, const std::filesystem::path& config);

}  // namespace hydrabench

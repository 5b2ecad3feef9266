// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/datasets/open_dataset.h"

#include <cstdlib>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "eval/datasets/apc_dataset.h"
#include "eval/datasets/folder_dataset.h"
#include "eval/datasets/folder_layout.h"
#include "eval/datasets/kitti_raw_dataset.h"
#include "eval/datasets/mesh_gallery.h"
#include "eval/datasets/rendered_datasets.h"
#include "eval/datasets/seven_scenes_dataset.h"

namespace hydrabench {
namespace fs = std::filesystem;
namespace {

/// Reads the rest of the config and calls finish(); fills in all but the resolved config.
struct DatasetType {
  const char* name;
  DatasetConfig (*read)(ConfigReader& reader, const fs::path& config);
};

constexpr DatasetType kTypes[] = {
    {"simulated", readSimulated},        {"folder", readFolder},
    {"placed_meshes", readPlacedMeshes}, {"mesh_gallery", readMeshGallery},
    {"seven_scenes", readSevenScenes},   {"apc2016", readApc},
    {"kitti_raw", readKittiRaw},
};

/// @param config  the file it is from; empty: none
DatasetConfig read(const ConfigDocument& document, const fs::path& config) {
  ConfigReader reader(document);
  std::vector<std::string> names;
  for (const DatasetType& type : kTypes) names.push_back(type.name);
  std::string type;
  if (!reader.has("type")) {
    reader.fault("type", fmt::format("missing, expected one of: {}", fmt::join(names, ", ")));
  }
  reader.choice("type", type, names);
  reader.throwFaults();  // without a type, no other key can be judged
  for (const DatasetType& candidate : kTypes) {
    if (type != candidate.name) continue;
    DatasetConfig dataset = candidate.read(reader, config);
    dataset.resolved_config = reader.resolved();
    return dataset;
  }
  std::abort();  // choice() lets only names of the table through
}

}  // namespace

DatasetConfig readDataset(const fs::path& path, const std::vector<std::string>& overrides) {
  const fs::path config = fs::is_directory(path) ? path / folder_layout::kDescription : path;
  ConfigDocument document = ConfigDocument::fromFile(config);
  for (const std::string& assignment : overrides) document.set(assignment);
  return read(document, config);
}

DatasetConfig readDataset(const ConfigDocument& document) { return read(document, {}); }

OpenedDataset openDataset(const fs::path& path, const std::vector<std::string>& overrides) {
  const DatasetConfig config = readDataset(path, overrides);
  return {config.open(), config.resolved_config};
}

OpenedDataset openDataset(const ConfigDocument& document) {
  const DatasetConfig config = readDataset(document);
  return {config.open(), config.resolved_config};
}

}  // namespace hydrabench

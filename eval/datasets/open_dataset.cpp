// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/datasets/open_dataset.h"

#include <cstdlib>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "eval/datasets/apc_dataset.h"
#include "eval/datasets/folder_dataset.h"
#include "eval/datasets/folder_layout.h"
#include "eval/datasets/mesh_gallery.h"
#include "eval/datasets/rendered_datasets.h"
#include "eval/datasets/seven_scenes_dataset.h"

namespace hydrabench {
namespace fs = std::filesystem;
namespace {

/// Reads the rest of the config, calls finish() and opens the data.
struct DatasetType {
  const char* name;
  std::unique_ptr<Dataset> (*open)(ConfigReader& reader, const fs::path& config);
};

constexpr DatasetType kTypes[] = {
    {"simulated", openSimulated},        {"folder", openFolder},
    {"placed_meshes", openPlacedMeshes}, {"mesh_gallery", openMeshGallery},
    {"seven_scenes", openSevenScenes},   {"apc2016", openApc},
};

/// @param config  the file it is from; empty: none
OpenedDataset open(const ConfigDocument& document, const fs::path& config) {
  ConfigReader reader(document);
  std::vector<std::string> names;
  for (const DatasetType& type : kTypes) names.push_back(type.name);
  std::string type;
  if (!reader.has("type")) {
    reader.fault("type", fmt::format("missing, expected one of: {}", fmt::join(names, ", ")));
  }
  reader.choice("type", type, names);
  if (config.empty() && type == "folder") {
    reader.fault("type", "a folder: its files stand beside a config file, and there is none here");
  }
  reader.throwFaults();  // without a type, no other key can be judged
  for (const DatasetType& candidate : kTypes) {
    if (type != candidate.name) continue;
    OpenedDataset opened;
    opened.dataset = candidate.open(reader, config);
    opened.resolved_config = reader.resolved();
    return opened;
  }
  std::abort();  // choice() lets only names of the table through
}

}  // namespace

OpenedDataset openDataset(const fs::path& path, const std::vector<std::string>& overrides) {
  const fs::path config = fs::is_directory(path) ? path / folder_layout::kDescription : path;
  ConfigDocument document = ConfigDocument::fromFile(config);
  for (const std::string& assignment : overrides) document.set(assignment);
  return open(document, config);
}

OpenedDataset openDataset(const ConfigDocument& document) { return open(document, {}); }

}  // namespace hydrabench

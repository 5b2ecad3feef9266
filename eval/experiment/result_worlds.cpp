// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/experiment/result_worlds.h"

#include <algorithm>
#include <optional>
#include <sstream>

#include <fmt/format.h>

#include "core/io/atomic_file.h"
#include "core/types/error.h"

namespace hydrabench {
namespace fs = std::filesystem;
namespace {

/// The block below `  key:` of the section `datasets`, four columns to the left.
std::optional<std::string> datasetConfig(const std::string& yaml, const std::string& key) {
  std::istringstream lines(yaml);
  bool in_datasets = false;
  bool in_block = false;
  std::string block;
  for (std::string line; std::getline(lines, line);) {
    if (!line.starts_with(" ") && !line.empty()) {
      if (in_block) break;
      in_datasets = line == "datasets:";
    } else if (in_datasets && !line.starts_with("    ") && !line.empty()) {
      if (in_block) break;
      in_block = line == "  " + key + ":";
    } else if (in_block) {
      block += (line.size() > 4 ? line.substr(4) : "") + "\n";
    }
  }
  if (block.empty()) return std::nullopt;
  return block;
}

std::vector<fs::path> sortedFolders(const fs::path& folder) {
  std::vector<fs::path> folders;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    if (entry.is_directory()) folders.push_back(entry.path());
  }
  // Numbers by value: shorter first.
  std::sort(folders.begin(), folders.end(), [](const fs::path& a, const fs::path& b) {
    const std::string x = a.filename().string();
    const std::string y = b.filename().string();
    const auto isNumber = [](const std::string& text) {
      return text.find_first_not_of("0123456789") == std::string::npos;
    };
    if (isNumber(x) && isNumber(y) && x.size() != y.size()) return x.size() < y.size();
    return x < y;
  });
  return folders;
}

}  // namespace

OpenedDataset ResultWorld::open() const {
  return openDataset(ConfigDocument::fromString(config, label()));
}

std::vector<ResultWorld> resultWorlds(const fs::path& result) {
  const fs::path predictions = result / "predictions";
  if (!fs::is_directory(predictions)) {
    throw InputError(fmt::format("{}: no predictions/ in there, expected a result folder of 'run'",
                                 result.string()));
  }
  const std::string yaml = readFile(result / "config.yaml");
  std::vector<ResultWorld> worlds;
  for (const fs::path& dataset : sortedFolders(predictions)) {
    for (const fs::path& seed : sortedFolders(dataset)) {
      ResultWorld world;
      world.dataset = dataset.filename().string();
      world.seed = seed.filename().string();
      world.predictions = sortedFolders(seed);
      const auto config = datasetConfig(yaml, world.label());
      if (!config) {
        throw InputError(fmt::format("{}: datasets: no '{}', expected the worlds of predictions/",
                                     (result / "config.yaml").string(), world.label()));
      }
      world.config = *config;
      worlds.push_back(std::move(world));
    }
  }
  return worlds;
}

DecisionConfig readDecisionOf(const fs::path& prediction) {
  ConfigReader reader(ConfigDocument::fromFile(prediction / "config.yaml"));
  DecisionConfig config;
  read(reader, config);
  reader.throwFaults();  // the other keys of the method are not ours to judge
  return config;
}

}  // namespace hydrabench

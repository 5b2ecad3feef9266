// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/datasets/dataset_config.h"

#include <cstdlib>
#include <limits>
#include <set>

#include <fmt/format.h>

#include "core/config/config_value.h"

namespace hydrabench {

void readCamera(ConfigReader& reader, Camera& camera) {
  ConfigReader section = reader.section("camera");
  for (const char* key : {"width_px", "height_px", "fx_px", "fy_px", "cx_px", "cy_px"}) {
    section.require(key);
  }
  section.field("width_px", camera.width, {1, 65535});
  section.field("height_px", camera.height, {1, 65535});
  section.field("fx_px", camera.fx, {1e-3, 1e6});
  section.field("fy_px", camera.fy, {1e-3, 1e6});
  section.field("cx_px", camera.cx, {-1e6, 1e6});
  section.field("cy_px", camera.cy, {-1e6, 1e6});
}

std::string cameraYaml(const Camera& camera) {
  return fmt::format(
      "camera:\n  width_px: {}\n  height_px: {}\n  fx_px: {}\n  fy_px: {}\n  cx_px: {}\n"
      "  cy_px: {}\n",
      camera.width, camera.height, camera.fx, camera.fy, camera.cx, camera.cy);
}

void readLabelSpace(ConfigReader& reader, LabelSpace& label_space) {
  std::set<Label> labels;
  for (ConfigReader& item : reader.list("label_space")) {
    LabelSpace::Entry entry;
    std::vector<int> color{0, 0, 0};
    item.require("label");
    item.require("name");
    item.field("label", entry.label, {0, std::numeric_limits<Label>::max()});
    item.field("name", entry.name);
    item.field("color", color, {0, 255});
    item.field("is_object", entry.is_object);
    item.field("is_scored", entry.is_scored);
    item.field("is_ground", entry.is_ground);
    if (color.size() == 3) {
      entry.color = {static_cast<std::uint8_t>(color[0]), static_cast<std::uint8_t>(color[1]),
                     static_cast<std::uint8_t>(color[2])};
    } else {
      item.fault("color", "expected [red, green, blue]");
    }
    if (entry.is_scored && !entry.is_object) {
      item.fault("is_scored", "only a class with is_object: true can be scored");
    }
    if (entry.is_ground && entry.is_object) {
      item.fault("is_ground", "a class with is_object: true cannot be ground");
    }
    if (!labels.insert(entry.label).second) {
      item.fault("label", fmt::format("{} is taken by an earlier class", entry.label));
    }
    label_space.entries.push_back(entry);
  }
}

std::string labelSpaceYaml(const LabelSpace& label_space) {
  std::string yaml = label_space.entries.empty() ? "label_space: []\n" : "label_space:\n";
  for (const LabelSpace::Entry& entry : label_space.entries) {
    yaml += fmt::format(
        "  - {{label: {}, name: {}, color: [{}, {}, {}], is_object: {}, is_scored: {}{}}}\n",
        entry.label, yamlText(entry.name), entry.color.r, entry.color.g, entry.color.b,
        entry.is_object, entry.is_scored, entry.is_ground ? ", is_ground: true" : "");
  }
  return yaml;
}

std::filesystem::path readDataRoot(ConfigReader& reader) {
  std::filesystem::path root;
  reader.path("root", root);
  std::string from;
  if (root.empty()) {
    const char* variable = std::getenv("HYDRABENCH_DATA");
    from = " (from --data or the environment variable HYDRABENCH_DATA)";
    if (variable) root = variable;
  }
  if (root.empty()) {
    reader.fault("root",
                 "no folder of data sets: give --data, the key root, or the environment variable "
                 "HYDRABENCH_DATA");
  } else if (!std::filesystem::is_directory(root)) {
    reader.fault("root", fmt::format("no such folder: {}{}", root.string(), from));
  }
  return root;
}

void requireFolder(ConfigReader& reader, const char* key, const std::filesystem::path& root,
                   const std::filesystem::path& folder) {
  if (!std::filesystem::is_directory(root)) return;  // a fault already
  if (!std::filesystem::is_directory(folder)) {
    reader.fault(key, fmt::format("no such folder: {}", folder.string()));
  }
}

}  // namespace hydrabench

// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "core/mapping/ground/ground_table.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "core/mapping/ground/no_ground.h"
#include "core/types/error.h"

namespace hydrabench {
namespace {

using Made = std::unique_ptr<GroundSegmenter>;

struct GroundType {
  const char* name;
  Made (*make)(const GroundConfig& config, const LabelSpace& label_space);
};

constexpr GroundType kTypes[] = {
    {"patchwork",
     [](const GroundConfig& config, const LabelSpace&) -> Made {
       return std::make_unique<Patchwork>(config.patchwork);
     }},
    {"semantic",
     [](const GroundConfig& config, const LabelSpace& label_space) -> Made {
       return std::make_unique<SemanticGround>(config.semantic, label_space);
     }},
    {"none",
     [](const GroundConfig&, const LabelSpace&) -> Made { return std::make_unique<NoGround>(); }},
};

}  // namespace

std::vector<std::string> groundTypes() {
  std::vector<std::string> names;
  for (const GroundType& type : kTypes) names.emplace_back(type.name);
  return names;
}

std::unique_ptr<GroundSegmenter> makeGroundSegmenter(const GroundConfig& config,
                                                     const LabelSpace& label_space) {
  for (const GroundType& type : kTypes) {
    if (config.type == type.name) return type.make(config, label_space);
  }
  throw InputError(fmt::format("ground, type: '{}', expected one of: {}", config.type,
                               fmt::join(groundTypes(), ", ")));
}

void read(ConfigReader& reader, GroundConfig& config) {
  reader.choice("type", config.type, groundTypes());
  auto patchwork = reader.section("patchwork");
  read(patchwork, config.patchwork);
  auto semantic = reader.section("semantic");
  read(semantic, config.semantic);
  if (config.type == "semantic" && config.semantic.labels.empty()) {
    semantic.fault("labels", "empty, expected at least one name of a class that is ground");
  }
}

}  // namespace hydrabench

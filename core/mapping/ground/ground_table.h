// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/config/config_reader.h"
#include "core/mapping/ground/ground_segmenter.h"
#include "core/mapping/ground/patchwork.h"
#include "core/mapping/ground/semantic_ground.h"
#include "core/types/label_space.h"

namespace hydrabench {

/// Which segmenter, and the settings of each, so that a sweep over the type needs no other keys.
struct GroundConfig {
  std::string type = "patchwork";  ///< of the table, see groundTypes()
  Patchwork::Config patchwork;
  SemanticGround::Config semantic;
};
/// Keys: type, and a section for each type that has settings.
void read(ConfigReader& reader, GroundConfig& config);

/// Throws InputError where the label space lacks a class that is named as ground.
std::unique_ptr<GroundSegmenter> makeGroundSegmenter(const GroundConfig& config,
                                                     const LabelSpace& label_space);

/// Names in the table, in its order.
std::vector<std::string> groundTypes();

}  // namespace hydrabench

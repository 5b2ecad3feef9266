// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "core/config/config_reader.h"
#include "core/mapping/ground/ground_segmenter.h"
#include "core/types/label_space.h"

namespace hydrabench {

/// Takes the points of some classes for ground, wherever they lie. Points of other classes are not
/// ground; points of unknown class are not judged.
class SemanticGround : public GroundSegmenter {
 public:
  struct Config {
    std::vector<std::string> labels;  ///< names of the classes that are ground
  };
  /// Throws InputError for a name that the label space does not have: a misspelt class would turn
  /// the ground off without a word.
  SemanticGround(const Config& config, const LabelSpace& label_space);

  /// Needs labels, one per point.
  GroundMask segment(const GroundScan& scan) override;

 private:
  std::vector<Label> ground_;  ///< ascending
};

void read(ConfigReader& reader, SemanticGround::Config& config);

}  // namespace hydrabench

// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "core/mapping/ground/semantic_ground.h"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "core/types/error.h"

namespace hydrabench {

SemanticGround::SemanticGround(const Config& config, const LabelSpace& label_space) {
  std::vector<std::string> names;
  for (const LabelSpace::Entry& entry : label_space.entries) names.push_back(entry.name);
  for (const std::string& name : config.labels) {
    const LabelSpace::Entry* entry = label_space.find(name);
    if (!entry) {
      const std::string guess = didYouMean(name, names);
      throw InputError(
          fmt::format("ground 'semantic', labels: '{}' is no class of the dataset; {}", name,
                      guess.empty() ? fmt::format("expected some of: {}", fmt::join(names, ", "))
                                    : fmt::format("did you mean '{}'?", guess)));
    }
    ground_.push_back(entry->label);
  }
  std::sort(ground_.begin(), ground_.end());
}

GroundMask SemanticGround::segment(const GroundScan& scan) {
  requireUsable(scan);
  const std::size_t count = scan.points.size();
  if (scan.labels.size() != count) {
    throw InputError(
        fmt::format("the scan at {} ns has no labels; expected {}, one per point: ground "
                    "'semantic' goes by them",
                    scan.stamp_ns, count));
  }
  GroundMask mask;
  mask.classes.assign(count, GroundClass::kNotJudged);
  for (std::size_t i = 0; i < count; ++i) {
    if (!isMeasured(scan.points[i])) {
      ++mask.num_invalid;
    } else if (scan.labels[i] != kUnknownLabel) {
      mask.classes[i] = std::binary_search(ground_.begin(), ground_.end(), scan.labels[i])
                            ? GroundClass::kGround
                            : GroundClass::kNonGround;
    }
  }
  return mask;
}

void read(ConfigReader& reader, SemanticGround::Config& config) {
  reader.field("labels", config.labels);
}

}  // namespace hydrabench

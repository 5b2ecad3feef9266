// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "core/mapping/class_mask.h"

#include <algorithm>
#include <cassert>
#include <cstddef>

namespace hydrabench {

std::vector<Label> labelsNamed(const std::vector<std::string>& names,
                               const LabelSpace& label_space) {
  std::vector<Label> labels;
  for (const std::string& name : names) {
    if (const LabelSpace::Entry* entry = label_space.find(name)) labels.push_back(entry->label);
  }
  return labels;
}

void maskClasses(const Image<Label>& image, const std::vector<Label>& classes,
                 Image<std::uint8_t>& mask) {
  assert(image.size() == mask.size());
  if (classes.empty()) return;
  for (std::size_t i = 0; i < image.size(); ++i) {
    if (std::find(classes.begin(), classes.end(), image.data()[i]) != classes.end()) {
      mask.data()[i] = 255;
    }
  }
}

}  // namespace hydrabench

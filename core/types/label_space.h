// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/types/color.h"
#include "core/types/ids.h"

namespace hydrabench {

/// The classes of a dataset: what the labels are called, how they are drawn, and which are objects.
struct LabelSpace {
  struct Entry {
    Label label = kUnknownLabel;
    std::string name;
    Rgb color;
    bool is_object = false;  ///< methods build object nodes of this class
    bool is_scored = false;  ///< the class counts in the evaluation; implies is_object
    bool is_ground = false;  ///< ground of the open air: road, grass, stairs; not an object
  };
  std::vector<Entry> entries;

  const Entry* find(Label label) const {
    for (const Entry& entry : entries) {
      if (entry.label == label) return &entry;
    }
    return nullptr;
  }
  const Entry* find(std::string_view name) const {
    for (const Entry& entry : entries) {
      if (entry.name == name) return &entry;
    }
    return nullptr;
  }
  /// Names of the classes that are ground, in the order of the entries.
  std::vector<std::string> groundNames() const {
    std::vector<std::string> names;
    for (const Entry& entry : entries) {
      if (entry.is_ground) names.push_back(entry.name);
    }
    return names;
  }
  /// The name, or "label_<id>" where the label is not listed.
  std::string nameOf(Label label) const {
    const Entry* entry = find(label);
    return entry ? entry->name : "label_" + std::to_string(label);
  }
};

}  // namespace hydrabench

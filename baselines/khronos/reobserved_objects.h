// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "core/graph/scene_graph.h"

namespace hydrabench {

/// Puts together what is one object seen at different times (the node merging of Khronos'
/// backend): same label, boxes that intersect, never seen at the same time.
class ReobservedObjects {
 public:
  /// @param min_iou  of the boxes, inclusive
  explicit ReobservedObjects(double min_iou) : min_iou_(min_iou) {}

  /// Merges the object into the one it matches with the largest IoU (the earliest of equals), which
  /// keeps its id; then the result into another if it matches now; until none does. Meshes are
  /// united, boxes are those of the meshes.
  void add(ObjectNode object);
  /// In order of their ids, which ascend with add().
  std::vector<ObjectNode> nodes() const;
  std::size_t numMerged() const { return num_merged_; }

 private:
  struct Interval {
    std::int64_t first_ns = 0;
    std::int64_t last_ns = 0;
  };
  struct Object {
    ObjectNode node;
    std::vector<Interval> seen;
  };
  static bool seenTogether(const Object& a, const Object& b);
  static void merge(Object&& from, Object& into);

  double min_iou_;
  std::size_t num_merged_ = 0;
  std::vector<Object> objects_;
};

}  // namespace hydrabench

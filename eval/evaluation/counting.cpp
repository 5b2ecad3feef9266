// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#include "eval/evaluation/counting.h"

namespace hydrabench {

std::optional<std::size_t> nearestOfClass(const DetectionObject& object,
                                          const std::vector<DetectionObject>& candidates) {
  std::optional<std::size_t> nearest;
  double nearest_distance = 0;
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    if (candidates[i].label != object.label || candidates[i].world != object.world) continue;
    const double distance = (candidates[i].center - object.center).norm();
    if (!nearest || distance < nearest_distance) {
      nearest = i;
      nearest_distance = distance;
    }
  }
  return nearest;
}

bool Counting::includes(const DetectionObject& estimate) const {
  const LabelSpace::Entry* entry = label_space.find(estimate.label);
  if (!entry || !entry->is_scored) return false;
  const auto near_ignored = nearestOfClass(estimate, ignored);
  if (!near_ignored) return true;
  const double distance = (ignored[*near_ignored].center - estimate.center).norm();
  if (!(distance < ignored[*near_ignored].half_diagonal)) return true;
  const auto near_truth = nearestOfClass(estimate, truths);
  return near_truth && !(distance < (truths[*near_truth].center - estimate.center).norm());
}

}  // namespace hydrabench

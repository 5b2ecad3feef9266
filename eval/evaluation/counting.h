// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "core/types/label_space.h"
#include "metrics/detection.h"

namespace hydrabench {

/// Index of the nearest object of the same class in the same world; nullopt where there is none.
std::optional<std::size_t> nearestOfClass(const DetectionObject& object,
                                          const std::vector<DetectionObject>& candidates);

/// What of a world counts, and so which estimates do.
struct Counting {
  LabelSpace label_space;
  std::vector<DetectionObject> truths;
  std::vector<DetectionObject> ignored;  ///< neither found nor missed

  /// Whether an estimate counts at all: its class is scored, and it does not stand for ground truth
  /// that is neither found nor missed.
  bool includes(const DetectionObject& estimate) const;
};

}  // namespace hydrabench

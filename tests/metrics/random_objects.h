// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "core/types/random.h"
#include "metrics/detection.h"

namespace hydrabench {

/// `count` objects of `classes` classes in a cube of edge `size_m`; ids are scattered.
inline std::vector<DetectionObject> randomObjects(std::size_t count, int classes, double size_m,
                                                  Random& random) {
  std::vector<DetectionObject> objects(count);
  for (DetectionObject& object : objects) {
    object.id = random.bits();
    object.label = static_cast<Label>(random.index(static_cast<std::uint32_t>(classes))) + 1;
    for (double& coordinate : object.center) coordinate = random.uniform(0, size_m);
    object.half_diagonal = random.uniform(0.1, 1.2);
  }
  return objects;
}

template <typename Value>
void shuffle(std::vector<Value>& values, Random& random) {
  for (std::size_t i = values.size(); i > 1; --i) {
    std::swap(values[i - 1], values[random.index(static_cast<std::uint32_t>(i))]);
  }
}

}  // namespace hydrabench

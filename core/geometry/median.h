// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include <Eigen/Core>

namespace hydrabench {

/// The value in the middle; of an even number the upper of the two there, so that it always is one
/// of the values. Needs a value, and none that is NaN. What it is given keeps its order: it works
/// on a copy, or on what is moved into it.
inline double median(std::vector<double> values) {
  assert(!values.empty());
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// The same of each coordinate by itself, so in general none of the points. Needs a point.
inline Eigen::Vector3d median(std::span<const Eigen::Vector3d> points) {
  Eigen::Vector3d result;
  for (int axis = 0; axis < 3; ++axis) {
    std::vector<double> values;
    values.reserve(points.size());
    for (const Eigen::Vector3d& point : points) values.push_back(point[axis]);
    result[axis] = median(std::move(values));
  }
  return result;
}

}  // namespace hydrabench

// SPDX-FileCopyrightText: 2026 The hydrabench authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/io/json_field.h"
#include "eval/datasets/pose_file.h"

namespace hydrabench {

/// A 4 x 4 matrix as four lists of four numbers. For .cpp files only, as json_field.h.
inline Transform readPose(const JsonField& field) {
  Eigen::Matrix4d matrix;
  if (field.size() != 4) field.fail("4 rows of 4 numbers");
  for (int row = 0; row < 4; ++row) {
    const JsonField numbers = field.item(static_cast<std::size_t>(row));
    if (numbers.size() != 4) numbers.fail("4 numbers");
    for (int column = 0; column < 4; ++column) {
      matrix(row, column) = numbers.item(static_cast<std::size_t>(column)).number();
    }
  }
  return checkedPose(matrix, field.place());
}

}  // namespace hydrabench
